// Reflections of the ground plane, inside and outside the picture, because rays can be intersected with a plane
// exactly. The ambient occlusion at the reflected point is unknown. It is assumed to equal the mirror's occlusion where
// the mirror touches the ground, and to fade to none at half the occlusion radius (twice the thickness of objects). The
// sun's light on the ground is added with the shading. The lamps' light on the ground is added with the reflections
// (REFLECTED), once for four pixels.
#include "draw/exact/rays/ground_ray.glsl"
#include "draw/exact/reflections/mirror_reach.glsl"
#include "draw/surface/ground_light.glsl"
#include "draw/exact/haze.glsl"
#ifdef SHADOW
#include "draw/exact/shadows/sun_map.glsl"
#endif

struct GroundMirrored {
  vec3 p;         // point where the reflected ray hits the ground
  float counts;   // weight of the reflection: the ground's alpha times the weight for the mirror's roughness; 0 if the
                  // ray misses the ground
  float open;
#ifdef HAZE
  float passes;   // fraction of light that the haze lets through between the mirror and the ground
#endif
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
#ifdef HAZE
  precise vec3 along = direction * max(metres, 0.0f);
  met.passes = passed(hazeBehind(p, along));
#endif
  return met;
}

vec3 groundInSun(GroundMirrored met, vec3 direction) {
#ifdef SHADOW
  float fraction = sunFraction(lightPlace(met.p), vec3(0, 1, 0));
#else
  const float fraction = 1.0f;
#endif
  vec3 light = withAround(sunOnGround(-direction, fraction, met.open), -direction, met.open);
#ifdef HAZE
  light = mirroredThroughHaze(light, met.passes, direction);
#endif
  return light;
}

#ifdef LAMPS
// Returns the lamps' light that the ground sends to the mirror.
vec3 lampsOnMirrored(GroundMirrored met, vec3 direction) {
  vec3 light = lampsOnGround(met.p, -direction);
#ifdef HAZE
  precise vec3 dimmed = light * met.passes;
  light = dimmed;
#endif
  return light;
}
#endif
