// Reads the material table of the ray scene (look_table.glsl).
#ifndef EXACT_RAY_LOOKS
#define EXACT_RAY_LOOKS
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/rays/look_table.glsl"
layout(binding = rayLookUnit) uniform usamplerBuffer materials;

uvec4 lookWords(int owner, int which) {
  return texelFetch(materials, lookTexels * owner + which);
}
vec4 lookOf(int owner, int which) {
  return uintBitsToFloat(lookWords(owner, which));
}
// Returns true if rays may pass through the material (holes, blending or transmission), so that a hit needs a closer
// test.
bool letsThrough(int owner) {
  return lookOf(owner, layerLook).w != 0.0f || lookOf(owner, sheenLook).w > 0.0f;
}
#endif
