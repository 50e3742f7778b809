// A small triangle's pixels, one after the other.
#include "draw/exact/raster_triangle.glsl"

void fillBox(Triangle t, uint id) {
  ivec2 first = max(t.low >> 8, ivec2(0));
  ivec2 last = min(t.high >> 8, PICTURE_SIZE - 1);
  if (last.x < first.x || last.y < first.y) return;
  ivec2 pixel = first;
  int pixels = (last.x - first.x + 1) * (last.y - first.y + 1);
  for (int i = 0; i < pixels; ++i) {
    ivec2 corner = pixel * subpixels;
    int e0 = edgeAt(t.edges[0], corner), e1 = edgeAt(t.edges[1], corner), e2 = edgeAt(t.edges[2], corner);
    int mask = 0;
    for (int s = 0; s < SAMPLES; ++s) {
      ivec2 aside = samplePlace(s) * (subpixels / 16);
      int all_ = edgeAside(t.edges[0], e0, aside) | edgeAside(t.edges[1], e1, aside) | edgeAside(t.edges[2], e2, aside);
      mask |= all_ >= 0 ? 1 << s : 0;
    }
    putPixel(t, pixel, mask, id);
    pixel = pixel.x < last.x ? ivec2(pixel.x + 1, pixel.y) : ivec2(first.x, pixel.y + 1);
  }
}
