// What mirrors show of the ground, seen or not: a plane, so that rays meet it where it is. What keeps the surroundings' light out there
// is not known: where the mirror stands on it as much as at the mirror, half a radius of occlusion away (twice the thickness of
// things) nothing. Shading takes it in the sun; what lamps add comes with the reflections (REFLECTED), once for four pixels.
#include "draw/exact/rays/ground_ray.glsl"
#include "draw/exact/reflections/mirror_reach.glsl"
#include "draw/surface/ground_light.glsl"
#ifdef SHADOW
#include "draw/exact/shadows/sun_map.glsl"
#endif

struct GroundMirrored {
  vec3 p;         // on the ground
  float counts;   // alpha, and less with the roughness as what else is mirrored; 0: there is none
  float open;
};

GroundMirrored groundMirrored(vec3 p, vec3 direction, float roughness, float openness) {
  float metres = roughness < mirrorRough ? groundAlong(p, direction) : -1.0f;
  GroundMirrored met;
  met.p = placeAlong(p, direction, metres);
  precise float away = 0.5f * metres * exactReciprocal(max(mirrorReach_.y, 1e-9f));
  precise float open = openness + (1.0f - openness) * clamp(away, 0.0f, 1.0f);
  precise float counts = groundAlpha(met.p) * smoothnessOf(roughness);
  met.open = open;
  met.counts = metres > 0.0f ? counts : 0.0f;
  return met;
}

vec3 groundInSun(GroundMirrored met, vec3 direction) {
#ifdef SHADOW
  float fraction = sunFraction(lightPlace(met.p), vec3(0, 1, 0));
#else
  const float fraction = 1.0f;
#endif
  return withAround(sunOnGround(-direction, fraction, met.open), -direction, met.open);
}
