// Rasterizes a triangle whose bounding box has at most 64 pixels per side. Sixteen invocations handle the triangle in
// blocks of 4 by 4 pixels.
#include "draw/exact/triangles/raster_triangle.glsl"
const uint teamSize = 16u;

void fillBlocks(Triangle t, uint id, uint member) {
  ivec2 first = max(t.low >> 8, ivec2(0)) + ivec2(int(member & 3u), int(member >> 2));
  ivec2 last = min(t.high >> 8, PICTURE_SIZE - 1);
  for (int y = first.y; y <= last.y; y += 4)
    for (int x = first.x; x <= last.x; x += 4) {
      ivec2 corner = ivec2(x, y) * subpixels;
      int e0 = edgeAt(t.edges[0], corner), e1 = edgeAt(t.edges[1], corner), e2 = edgeAt(t.edges[2], corner);
      int mask = 0;
      for (int s = 0; s < SAMPLES; ++s) {
        ivec2 aside = samplePlace(s) * (subpixels / 16);
        int all_ = edgeAside(t.edges[0], e0, aside) | edgeAside(t.edges[1], e1, aside) | edgeAside(t.edges[2], e2, aside);
        mask |= all_ >= 0 ? 1 << s : 0;
      }
      if (mask != 0) putPixel(t, ivec2(x, y), mask, id);
    }
}
