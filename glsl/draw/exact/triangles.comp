// Small triangles of one surface, an invocation each; the numbers of the others go on a list (large.comp). SAMPLES, PASS,
// SUN_MAP, COUNTED.
#include "draw/exact/raster.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = largeBinding) restrict buffer LargeBlock { uint large[]; };
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint counters[]; };
uniform int draw_;         // number of the surface among those drawn
uniform int smallPixels;   // the longest side of a small triangle's box

void main() {
  int number = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (number >= trianglesToDraw()) return;
  ivec3 corners = cornersOf(number);
  uvec4 a = texelFetch(vertices, corners.x), b = texelFetch(vertices, corners.y), c = texelFetch(vertices, corners.z);
  if (a.w == lostVertex || b.w == lostVertex || c.w == lostVertex) return;
  vec2 size = vec2(PICTURE_SIZE);
#ifndef SUN_MAP
  float nearest = view.near;
#endif
  if (beside(placeOf(a), placeOf(b), placeOf(c), size, nearest)) return;
  bool whole = inside(placeOf(a), size, nearest) && inside(placeOf(b), size, nearest) && inside(placeOf(c), size, nearest);
  Triangle t;
  t.empty = false;
  t.low = t.high = ivec2(0);
  if (whole) t = drawnTriangle(cornerOfVertex(a), cornerOfVertex(b), cornerOfVertex(c));
  if (t.empty) return;
  ivec2 extent = t.high - t.low;
  if (!whole || max(extent.x, extent.y) > smallPixels * subpixels) {
#if PASS == 0
    large[firstIndex / 3 + int(atomicAdd(counters[draw_], 1u))] = uint(number);
#endif
    return;
  }
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
    putPixel(t, pixel, mask, firstId + uint(number));
    pixel = pixel.x < last.x ? ivec2(pixel.x + 1, pixel.y) : ivec2(first.x, pixel.y + 1);
  }
}
