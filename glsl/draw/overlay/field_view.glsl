// Uniforms and defines of a field's position in the picture. REDUCED: reads a texture of averaged blocks. RELIEF:
// shades the field as if lit. OVER: returns encoded colours for the finished picture instead of light. SPLINED:
// interpolates values or colours between cells, which are squares otherwise. FINE: no pixel covers more than half a
// cell on a side, so a SPLINED field needs no means. TILED: repeats the field beyond its borders, where `border` is
// displayed otherwise. These are defines because software drivers execute both sides of every branch and divisions are
// expensive.
#ifdef REDUCED
layout(binding = reducedUnit) uniform sampler2D reduced;
#endif
uniform ivec2 size;      // size of the field in elements: cells, or texels of `reduced`
uniform ivec2 base;  // pixel p covers the elements from base + start + perPixel p to base + start + perPixel (p + 1)
uniform vec2 start;
uniform vec2 perPixel;
uniform vec3 border;
uniform float opacity;
uniform vec2 slope;      // relief height of the field's whole value range, in elements along x and y
#ifdef EXACT_PICTURE  // copies, so that kernels read the uniforms only once, before their loops
#include "common/once.glsl"
ivec2 size_ = once(size);
ivec2 base_ = once(base);
vec2 start_ = once(start);
vec2 perPixel_ = once(perPixel);
vec3 border_ = once(border);
float opacity_ = once(opacity);
vec2 slope_ = once(slope);
#define size size_
#define base base_
#define start start_
#define perPixel perPixel_
#define border border_
#define opacity opacity_
#define slope slope_
#endif
#ifdef TILED
const bool tiled = true;
#else
const bool tiled = false;
#endif
#ifdef MAGNIFIED
const bool magnified = true;
#else
const bool magnified = false;
#endif
#ifdef RELIEF
const bool relief = true;
#else
const bool relief = false;
#endif
#ifdef OVER
const bool encodes = true;
#else
const bool encodes = false;
#endif

#ifdef SPLINED
const bool splined = true;
#else
const bool splined = false;
#endif
#ifdef FINE
const bool fine = true;
#else
const bool fine = false;
#endif

#ifdef REDUCED
const bool reduces = true;
vec4 reducedAt(ivec2 at) {
  return texelFetch(reduced, at, 0);
}
#else
const bool reduces = false;
vec4 reducedAt(ivec2 at) {
  return vec4(0.0);
}
#endif
