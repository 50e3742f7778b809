// Rasterizes triangles. In shadow maps, triangles are moved away from the light in proportion to their slope. ADDS:
// adds light to the sums of glows. CUTOUT: triangles have holes. LAYER: triangles of blended surfaces, one layer at a
// time. Defines: as for visible_sample.glsl.
#include "draw/exact/visible_sample.glsl"
#include "draw/exact/triangles/triangle.glsl"
#include "draw/exact/triangles/clip.glsl"
#ifdef CUTOUT
#include "draw/exact/triangles/cutout.glsl"
#endif
#ifdef LAYER
#include "draw/exact/triangles/layer.glsl"
#endif
#ifdef SUN_MAP
uniform float slopeOffset;  // depth offset in texels of slope: the triangle's slope times this number of texels
const float nearest = 0.0f;
#endif
#ifdef LAMP_MAP
uniform float slopeOffset;
#endif
#ifdef JOINED
bool doubleSided = true;  // true if both sides of the current triangle are visible
#else
uniform bool doubleSided;
#endif
#ifdef ADDS
#include "draw/frame_block.glsl"
#include "draw/exact/instances/glow_add.glsl"
vec3 addedLight = vec3(0.0f);
#endif

// Prepares a triangle for rasterization; hidden triangles become empty.
Triangle drawnTriangle(Corner a, Corner b, Corner c) {
  Triangle t = triangleOf(a, b, c);
#if defined SUN_MAP || defined LAMP_MAP
  // Polygon offset: slope times slopeOffset texels, plus a small constant for depth rounding.
  precise float offset = max(abs(t.acrossNear), abs(t.downNear)) * slopeOffset * float(subpixels) + 4e-7f;
  precise float near = t.near - offset;
  precise float minimum = t.minimum - offset;
  precise float maximum = t.maximum - offset;
  t.near = near;
  t.minimum = max(minimum, 0.0f);
  t.maximum = max(maximum, 0.0f);
#else
  t.empty = t.empty || (t.turned && !doubleSided);
#endif
  return t;
}

#ifdef ADDS
void putPixel(Triangle t, ivec2 pixel, int mask, uint id) {
  int at = firstSample(pixel), samples = 0;
  for (int s = 0; s < SAMPLES; ++s) {
    float near = nearAt(t, pixel * subpixels + samplePlace(s) * (subpixels / 16));
    bool seen = (mask >> s & 1) != 0 && near >= view.nearOverFar && nearKey(near) < keyAt(at + s);
    samples += seen ? 1 : 0;
  }
  addPart(pixel, addedLight, 1.0f, samples);
}
#else
// Writes sample `s` of the pixel. The triangle must cover the sample.
void putSample(Triangle t, ivec2 pixel, int s, uint before, uint id) {
  float near = nearAt(t, pixel * subpixels + samplePlace(s) * (subpixels / 16));
#ifndef SUN_MAP
  if (near < view.nearOverFar) return;
#endif
#ifdef LAYER
  if (!inLayer(sampleIndex(pixel, s), nearKey(near), id)) return;
#endif
  keep(sampleIndex(pixel, s), nearKey(near), before, id);
}

// Writes the samples in the mask of one pixel. The triangle must cover the samples.
void putPixel(Triangle t, ivec2 pixel, int mask, uint id) {
#ifdef CUTOUT
  mask = uncut(pixel, mask);
#endif
#if SAMPLES < 4
  for (int s = 0; s < SAMPLES; ++s)
    if ((mask >> s & 1) != 0) putSample(t, pixel, s, keyAt(sampleIndex(pixel, s)), id);
#else
  int at = firstSample(pixel);
  for (int s = 0; s < SAMPLES; s += 4) {  // a software driver reads four keys as fast as one key
    uvec4 before = fourKeysAt(at + s);
    for (int i = 0; i < 4; ++i)
      if ((mask >> (s + i) & 1) != 0) putSample(t, pixel, s + i, before[i], id);
  }
#endif
}
#endif
