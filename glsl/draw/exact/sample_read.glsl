// What samples show, read: keys of nearness and numbers. PAIRED: both lie together, number first; else apart.
#ifndef EXACT_SAMPLE_READ
#define EXACT_SAMPLE_READ
#include "draw/exact/bindings.glsl"
#ifdef PAIRED
layout(binding = nearUnit) uniform usamplerBuffer nearestKeys;
layout(binding = nearFoursUnit) uniform usamplerBuffer nearestFours;  // the same memory, two samples a texel

uint keyAt(int at) {
  return texelFetch(nearestKeys, at).y;
}
uint idAt(int at) {
  return texelFetch(nearestKeys, at).x;
}
// Of samples `at`, a multiple of 4, to at + 3.
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
layout(binding = nearFoursUnit) uniform usamplerBuffer nearestFours;  // the same memory, four a texel
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
