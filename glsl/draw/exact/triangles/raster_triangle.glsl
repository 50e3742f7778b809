// Drawing triangles that some kernel has made. Variants of visible_sample.glsl; into shadow maps they are moved away by
// their slope. ADDS: they add light to the sums of glows. CUTOUT:
// they have holes; LAYER: they are of a layer of blended ones.
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
uniform float slopeOffset;  // texels whose slope the map is moved by
const float nearest = 0.0f;
#endif
#ifdef LAMP_MAP
uniform float slopeOffset;
#endif
#ifdef JOINED
bool doubleSided = true;  // of the triangle that is being drawn
#else
uniform bool doubleSided;
#endif
#ifdef ADDS
#include "draw/frame_block.glsl"
#include "draw/exact/instances/glow_add.glsl"
vec3 addedLight = vec3(0.0f);
#endif

// Ready to be drawn: hidden ones are empty.
Triangle drawnTriangle(Corner a, Corner b, Corner c) {
  Triangle t = triangleOf(a, b, c);
#if defined SUN_MAP || defined LAMP_MAP
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
// Sample `s` of the pixel, which the triangle covers.
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

// The samples that the mask has, of one pixel.
void putPixel(Triangle t, ivec2 pixel, int mask, uint id) {
#ifdef CUTOUT
  mask = uncut(pixel, mask);
#endif
#if SAMPLES < 4
  for (int s = 0; s < SAMPLES; ++s)
    if ((mask >> s & 1) != 0) putSample(t, pixel, s, keyAt(sampleIndex(pixel, s)), id);
#else
  int at = firstSample(pixel);
  for (int s = 0; s < SAMPLES; s += 4) {  // software drivers fetch four as dearly as one
    uvec4 before = fourKeysAt(at + s);
    for (int i = 0; i < 4; ++i)
      if ((mask >> (s + i) & 1) != 0) putSample(t, pixel, s + i, before[i], id);
  }
#endif
}
#endif
