// What the kernels that find what is visible have in common. SAMPLES; PASS 0 keeps the nearest at each sample, pass 1
// the least number among those that are as near. SUN_MAP: only the nearest, moved away by the slope.
#include "draw/exact/surface_triangle.glsl"
#include "draw/exact/triangle.glsl"
#include "draw/exact/clip.glsl"
#ifdef SUN_MAP
uniform int mapTexels;
uniform float slopeOffset;  // texels whose slope the map is moved by
const float nearest = 0.0f, farthestNear = 0.0f;
#define PICTURE_SIZE ivec2(mapTexels)
#else
#include "draw/exact/view_block.glsl"
#define PICTURE_SIZE view.size
#endif
layout(std430, binding = nearBinding) restrict buffer NearBlock { uint nearKeys[]; };
layout(std430, binding = idBinding) restrict buffer IdBlock { uint ids[]; };
layout(binding = nearUnit) uniform usamplerBuffer nearestKeys;  // the same memory
uniform bool doubleSided;
uniform uint firstId;

Corner cornerOfVertex(uvec4 vertex) {
#ifdef SUN_MAP
  Corner corner = cornerOf(placeOf(vertex), 0.0f);
  corner.near = intBitsToFloat(int(vertex.w));
  return corner;
#else
  return cornerOf(placeOf(vertex), view.near);
#endif
}

// Ready to be drawn: hidden ones are empty.
Triangle drawnTriangle(Corner a, Corner b, Corner c) {
  Triangle t = triangleOf(a, b, c);
#ifdef SUN_MAP
  // As a polygon offset: by so many texels' slope and, for the bits of the depth, a little more.
  precise float offset = max(abs(t.acrossNear), abs(t.downNear)) * slopeOffset * float(subpixels) + 4e-7f;
  precise float near = t.near - offset;
  precise float least = t.least - offset;
  precise float most = t.most - offset;
  t.near = near;
  t.least = max(least, 0.0f);
  t.most = max(most, 0.0f);
#else
  t.empty = t.empty || (t.turned && !doubleSided);
#endif
  return t;
}

// Sample `s` of the pixel, which the triangle covers.
void putSample(Triangle t, ivec2 pixel, int s, uint before, uint id) {
  float near = nearAt(t, pixel * subpixels + samplePlace(s) * (subpixels / 16));
#ifndef SUN_MAP
  if (near < view.nearOverFar) return;
#endif
  uint key = nearKey(near);
  int at = (pixel.y * PICTURE_SIZE.x + pixel.x) * SAMPLES + s;
#if PASS == 0
  if (key < before) atomicMin(nearKeys[at], key);
#else
  if (key == before) atomicMin(ids[at], id);
#endif
}

// The samples that the mask has, of one pixel.
void putPixel(Triangle t, ivec2 pixel, int mask, uint id) {
  int at = (pixel.y * PICTURE_SIZE.x + pixel.x) * SAMPLES;
  for (int s = 0; s < SAMPLES; ++s)
    if ((mask >> s & 1) != 0) putSample(t, pixel, s, texelFetch(nearestKeys, at + s).x, id);
}
