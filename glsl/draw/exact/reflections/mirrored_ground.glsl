// Reflections of the ground plane, inside and outside the picture, because rays can be intersected with a plane
// exactly. The ambient occlusion at the reflected point is unknown. It is assumed to equal the mirror's occlusion where
// the mirror touches the ground, and to fade to none at half the occlusion radius (twice the thickness of objects). The
// sun's light on the ground is added with the shading. The lamps' light on the ground is added with the reflections
// (REFLECTED), once for four pixels.
#include "draw/exact/rays/ground_ray.glsl"
#include "draw/exact/reflections/mirror_reach.glsl"
#include "draw/surface/ground_light.glsl"
#ifdef SHADOW
#include "draw/exact/shadows/sun_map.glsl"
#endif

struct GroundMirrored {
  vec3 p;         // point where the reflected ray hits the ground
  float counts;   // weight of the reflection: the ground's alpha times the weight for the mirror's roughness; 0 if the
                  // ray misses the ground
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
