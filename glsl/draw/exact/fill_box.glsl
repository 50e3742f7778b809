// A small triangle's pixels, row by row: of each those between its edges, which the last digits of a float do not decide.
// BRANCHES: an invocation saves what it leaves out.
#include "draw/exact/raster_triangle.glsl"

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

void fillBox(Triangle t, uint id) {
  ivec2 first = max(t.low >> 8, ivec2(0, PICTURE_ROWS.x));
  ivec2 last = min(t.high >> 8, ivec2(PICTURE_SIZE.x, PICTURE_ROWS.y) - 1);
  Crossing a = crossingOf(t.edges[0]), b = crossingOf(t.edges[1]), c = crossingOf(t.edges[2]);
  ivec3 across = ivec3(t.edges[0].step_.y, t.edges[1].step_.y, t.edges[2].step_.y) * subpixels;
  for (int y = first.y; y <= last.y; ++y) {
    ivec2 span = ivec2(first.x, last.x);
    span = between(span, t.edges[0], a, y * subpixels);
    span = between(span, t.edges[1], b, y * subpixels);
    span = between(span, t.edges[2], c, y * subpixels);
    ivec2 corner = ivec2(span.x, y) * subpixels;
    ivec3 e = ivec3(edgeAt(t.edges[0], corner), edgeAt(t.edges[1], corner), edgeAt(t.edges[2], corner));
    for (int x = span.x; x <= span.y; ++x) {
      int mask = 0;
      for (int s = 0; s < SAMPLES; ++s) {
        ivec2 aside = samplePlace(s) * (subpixels / 16);
        int all_ = edgeAside(t.edges[0], e.x, aside) | edgeAside(t.edges[1], e.y, aside) | edgeAside(t.edges[2], e.z, aside);
        mask |= all_ >= 0 ? 1 << s : 0;
      }
#ifdef BRANCHES
      if (mask != 0)
#endif
        putPixel(t, ivec2(x, y), mask, id);
      e += across;
    }
  }
}
