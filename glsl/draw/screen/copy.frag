// Shades instanced copies of a mesh or sphere. ADDITIVE: unlit light of one colour. Defines: DOUBLE_SIDED, and the
// defines of draw/surface/lighting.glsl.
#include "draw/frame_block.glsl"
#include "draw/surface/material.glsl"
#include "draw/surface/shadow_read.glsl"
flat in vec3 tint;
in vec3 worldNormal;
in vec3 worldPosition;
in vec3 place;
#ifdef LAMPS
in vec3 onRound;
#define LIT_FROM onRound
#else
#define LIT_FROM worldPosition
#endif
layout(location = 0) out vec4 radiance;

void main() {
#ifdef ADDITIVE
  radiance = vec4(tint, 0.0);
#else
  vec3 normal = normalize(worldNormal);
#ifdef DOUBLE_SIDED
  normal = gl_FrontFacing ? normal : -normal;
#endif
  vec3 view = normalize(frame.eye.xyz - frame.eye.w * worldPosition);
  radiance = vec4(allLight(lookOf(tint), LIT_FROM, normal, view, sunFraction(place)), 1.0);
#endif
}
