// What mirrors show of the ground, seen or not: a plane, so that rays meet it where it is, lit as it is elsewhere, by sun and lamps
// with their shadows. What keeps the surroundings' light out there is not known: where the mirror stands on it as much as at the
// mirror, half a radius of occlusion away (twice the thickness of things) nothing.
#include "draw/exact/rays/ground_ray.glsl"
#include "draw/exact/reflections/mirror_reach.glsl"
#include "draw/surface/ground_light.glsl"
#ifdef SHADOW
#include "draw/exact/shadows/sun_map.glsl"
#endif

// Times how much it counts, and that: alpha, and less with the roughness as what else is mirrored. `metres`: along the ray from p.
vec4 groundAlongMirrored(vec3 p, vec3 direction, float metres, float roughness, float openness) {
  vec3 there = placeAlong(p, direction, metres);
#ifdef SHADOW
  float fraction = sunFraction(lightPlace(there), vec3(0, 1, 0));
#else
  const float fraction = 1.0f;
#endif
  precise float away = 0.5f * metres * exactReciprocal(mirrorReach_.y);
  precise float open = openness + (1.0f - openness) * clamp(away, 0.0f, 1.0f);
  precise vec4 light = groundLight(there, -direction, fraction, open) * smoothnessOf(roughness);
  return light;
}

// The same, or nothing where there is no ground. In a loop, which ends at once then: software drivers run both sides of a branch.
vec4 groundMirrored(vec3 p, vec3 direction, float roughness, float openness) {
  float metres = roughness < mirrorRough ? groundAlong(p, direction) : -1.0f;
  vec4 light = vec4(0.0f);
  for (int i = metres > 0.0f ? 0 : 1; i < 1; ++i) light = groundAlongMirrored(p, direction, metres, roughness, openness);
  return light;
}
