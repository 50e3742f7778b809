// Conservative ranges of the pixels or tiles of a row that are inside a triangle's edges, in float arithmetic. An edge
// crosses rows at x = at + slope (y - from), in 1/256 pixel. `side` is 1 if the triangle is to the right of the edge,
// -1 if it is to the left.
struct Crossing {
  float slope;
  int side;
};

Crossing crossingOf(Edge edge) {
  float perDown = exactReciprocal(float(edge.step_.y != 0 ? edge.step_.y : 1));
  precise float slope = float(edge.step_.x) * perDown;
  return Crossing(slope, sign(edge.step_.y));
}

// Limits the range `span` of a row to the pixels that may be inside one edge. Returns the first and last pixel. `top`
// is the upper side of the row (1/256 pixel).
ivec2 between(ivec2 span, Edge edge, Crossing crossing, int top) {
  precise float upper = crossing.slope * float(top - edge.from.y);
  precise float lower = upper + crossing.slope * 256.0f;
  float low = clamp(min(upper, lower), -1e6f, 1e6f), high = clamp(max(upper, lower), -1e6f, 1e6f);
  int first = (int(floor(low)) + edge.from.x - 2) >> 8, last = (int(floor(high)) + edge.from.x + 2) >> 8;
  return ivec2(crossing.side > 0 ? max(span.x, first) : span.x, crossing.side < 0 ? min(span.y, last) : span.y);
}

// Limits the range `span` of a row of tiles to the tiles that may be inside one edge. Returns the first and last tile.
// The tolerance covers the float errors of the largest triangles, a few 1/256 pixel inside the picture.
ivec2 tilesBetween(ivec2 span, Edge edge, Crossing crossing, int row) {
  const int tile = tileSide * subpixels;
  precise float upper = crossing.slope * float(row * tile - edge.from.y);
  precise float lower = upper + crossing.slope * float(tile);
  float low = clamp(min(upper, lower), -1e8f, 1e8f), high = clamp(max(upper, lower), -1e8f, 1e8f);
  int first = (int(floor(low)) + edge.from.x - subpixels) >> 11, last = (int(floor(high)) + edge.from.x + subpixels) >> 11;
  return ivec2(crossing.side > 0 ? max(span.x, first) : span.x, crossing.side < 0 ? min(span.y, last) : span.y);
}
