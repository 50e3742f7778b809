// Which pixels or tiles of a row a triangle's edges leave to it, in floats: never too few.
// Where an edge crosses rows: x = at + slope (y - from), in 1/256 pixel; 1 where the inside is to its right, -1 to its left.
struct Crossing {
  float slope;
  int side;
};

Crossing crossingOf(Edge edge) {
  float perDown = exactReciprocal(float(edge.step_.y != 0 ? edge.step_.y : 1));
  precise float slope = float(edge.step_.x) * perDown;
  return Crossing(slope, sign(edge.step_.y));
}

// First and last pixel of a row whose upper side is at `top` (1/256 pixel) that may lie inside, no matter the rest.
ivec2 between(ivec2 span, Edge edge, Crossing crossing, int top) {
  precise float upper = crossing.slope * float(top - edge.from.y);
  precise float lower = upper + crossing.slope * 256.0f;
  float low = clamp(min(upper, lower), -1e6f, 1e6f), high = clamp(max(upper, lower), -1e6f, 1e6f);
  int first = (int(floor(low)) + edge.from.x - 2) >> 8, last = (int(floor(high)) + edge.from.x + 2) >> 8;
  return ivec2(crossing.side > 0 ? max(span.x, first) : span.x, crossing.side < 0 ? min(span.y, last) : span.y);
}

// First and last tile of a row of them. Of triangles as large as may be: floats err by a few 1/256 of a pixel inside the picture.
ivec2 tilesBetween(ivec2 span, Edge edge, Crossing crossing, int row) {
  const int tile = tileSide * subpixels;
  precise float upper = crossing.slope * float(row * tile - edge.from.y);
  precise float lower = upper + crossing.slope * float(tile);
  float low = clamp(min(upper, lower), -1e8f, 1e8f), high = clamp(max(upper, lower), -1e8f, 1e8f);
  int first = (int(floor(low)) + edge.from.x - subpixels) >> 11, last = (int(floor(high)) + edge.from.x + subpixels) >> 11;
  return ivec2(crossing.side > 0 ? max(span.x, first) : span.x, crossing.side < 0 ? min(span.y, last) : span.y);
}
