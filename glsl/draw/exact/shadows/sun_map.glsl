// Fraction of the sun that reaches a place, filtered over frame.shadowSoftness texels of the sun's map. SHADOW_TAPS.
#include "draw/exact/light_place.glsl"
#include "draw/exact/shadows/shadow_filter.glsl"
layout(binding = mapUnit) uniform usamplerBuffer sunMap;

float sunFraction(vec3 place) {
  int side = int(frame.shadowTexels);
  precise float near = 1.0f - place.z;
  uint key = nearKey(max(near, 0.0f));  // behind every caster still counts as inside the map
  precise vec2 middle = place.xy * frame.shadowTexels;
  ShadowMap map = ShadowMap(side, 0, side);
#if SHADOW_TAPS == 4
  return litByFour(sunMap, map, middle, key, frame.shadowSoftness);
#else
  return litBySixteen(sunMap, map, middle, key, frame.shadowSoftness);
#endif
}

// A step to the lit side of a surface: looked up there, it does not shade itself.
float sunFractionOn(vec3 p, vec3 normal) {
  precise float turned = 4.0f * exactDot(normal, frame.sunDirection.xyz);
  precise float lift = clamp(turned, -1.0f, 1.0f) * lightTexel() * (0.5f + 0.5f * frame.shadowSoftness);
  precise vec3 lifted = p + normal * lift;
  return sunFraction(lightPlace(lifted));
}
