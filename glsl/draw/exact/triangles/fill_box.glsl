// Rasterizes a small triangle row by row, over the pixels between its edges. Float rounding does not affect the result.
// BRANCHES: the device saves time if an invocation skips work.
#include "draw/exact/triangles/raster_triangle.glsl"
#include "draw/exact/triangles/crossing.glsl"
uniform int smallPixels;  // max side (pixels) of a small triangle's bounding box

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

// Returns the longer side of a triangle's bounding box (1/256 pixel), which determines how the triangle is rasterized.
// On software drivers slivers count as small, because they cover little of their tiles and often occur in large
// numbers. The limits keep the edge function E below 2^31 near the triangle; partial products may wrap around.
// A software driver ends the loops of an invocation after 65,535 iterations. CUTOUT: each sample of a pixel takes up to
// eight, so a triangle that covers too many pixels counts as large.
int drawnAs(Triangle t) {
  int longest = max(t.high.x - t.low.x, t.high.y - t.low.y);
#ifndef BRANCHES
#ifdef CUTOUT
  const float maxAround = float(110000 / (2 + 8 * SAMPLES));
#else
  const float maxAround = 24576.0f;
#endif
  ivec2 u = t.edges[0].step_, v = t.edges[1].step_;
  precise float doubled = (float(u.x) * float(v.y) - float(u.y) * float(v.x)) * 1.5258789e-5f;
  precise float length_ = float(longest) * 0.00390625f;
  precise float thick = length_ * float(smallPixels) * 0.25f;
  precise float around = abs(doubled) + 4.0f * length_;
  int small = smallPixels * subpixels;
  if (abs(doubled) <= thick && around <= maxAround && length_ <= 2048.0f) longest = min(longest, small);
#ifdef CUTOUT
  if (around > maxAround) longest = max(longest, small + 1);
#endif
#endif
  return longest;
}
