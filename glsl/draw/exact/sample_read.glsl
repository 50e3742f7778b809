// Reads the samples of a visibility buffer: depth keys and primitive ids. PAIRED: the id and the key of a sample are
// stored together, id first; otherwise they are in separate buffers.
#ifndef EXACT_SAMPLE_READ
#define EXACT_SAMPLE_READ
#include "draw/exact/bindings.glsl"
#ifdef PAIRED
layout(binding = nearUnit) uniform usamplerBuffer nearestKeys;
// Texel view of the same buffer, two samples per texel.
layout(binding = nearFoursUnit) uniform usamplerBuffer nearestFours;

uint keyAt(int at) {
  return texelFetch(nearestKeys, at).y;
}
uint idAt(int at) {
  return texelFetch(nearestKeys, at).x;
}
// Returns the keys of the samples at, at + 1, at + 2 and at + 3; `at` must be a multiple of 4.
uvec4 fourKeysAt(int at) {
  uvec4 a = texelFetch(nearestFours, at / 2), b = texelFetch(nearestFours, at / 2 + 1);
  return uvec4(a.y, a.w, b.y, b.w);
}
uvec4 fourIdsAt(int at) {
  uvec4 a = texelFetch(nearestFours, at / 2), b = texelFetch(nearestFours, at / 2 + 1);
  return uvec4(a.x, a.z, b.x, b.z);
}
#else
layout(binding = nearUnit) uniform usamplerBuffer nearestKeys;
// Texel view of the same buffer, four samples per texel.
layout(binding = nearFoursUnit) uniform usamplerBuffer nearestFours;
layout(binding = idUnit) uniform usamplerBuffer visibleIds;
layout(binding = idFoursUnit) uniform usamplerBuffer visibleFours;

uint keyAt(int at) {
  return texelFetch(nearestKeys, at).x;
}
uint idAt(int at) {
  return texelFetch(visibleIds, at).x;
}
uvec4 fourKeysAt(int at) {
  return texelFetch(nearestFours, at / 4);
}
uvec4 fourIdsAt(int at) {
  return texelFetch(visibleFours, at / 4);
}
#endif
#endif
