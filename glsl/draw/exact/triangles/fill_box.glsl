// A small triangle's pixels, row by row: of each those between its edges, which the last digits of a float do not decide.
// BRANCHES: an invocation saves what it leaves out.
#include "draw/exact/triangles/raster_triangle.glsl"
#include "draw/exact/triangles/crossing.glsl"

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
