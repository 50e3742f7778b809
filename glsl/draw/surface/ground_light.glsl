// Light that the ground reflects to the eye. `fraction` is the fraction of sunlight that reaches the point. `openness`
// is the fraction of ambient light that reaches the point. Defines: GROUND_REFLECTIVE, LAMPS, REFLECTED as in
// lighting.glsl. Compiles as GLSL and as C++.
#ifndef DRAW_GROUND_LIGHT
#define DRAW_GROUND_LIGHT
#include "draw/sky.glsl"
#include "draw/surface/ground_alpha.glsl"
#include "draw/surface/shading.glsl"
#ifdef LAMPS
#include "draw/lights/lamps.glsl"
#endif

FUNCTION vec3 ambientOnGround() {
#ifdef ENVIRONMENT
  return ambientOn(vec3(0, 1, 0));
#else
  return vec3(frame.ambientUp);
#endif
}

#ifdef GROUND_REFLECTIVE
// Returns the radiance of the surroundings that the ground reflects towards `view`. The caller multiplies it by the
// weight F0 x + y of ambientLobe().
FUNCTION vec3 aroundGround(vec3 view) {
#ifdef ENVIRONMENT
  return environmentMirrored(vec3(-view.x, abs(view.y), -view.z), frame.groundRoughness);
#else
  return blend(skyRadiance(abs(view.y)), ambientOnGround(), frame.groundRoughness);
#endif
}
#endif

FUNCTION Shares sharesOfGround(vec3 view) {
  return barycentricWeights(vec3(frame.groundColor), frame.groundRoughness, 0.0f, view.y);
}

// Returns the sun's diffuse and specular light plus the diffuse ambient light.
FUNCTION vec3 sunOnGround(vec3 view, float fraction, float openness) {
  vec3 sun = vec3(frame.sunDirection), sunLight = vec3(frame.sunLight), color = sharesOfGround(view).matt;
  ROUNDED float lit = max(sun.y, 0.0f) * fraction;
  vec3 ambientUp = ambientOnGround();
  vec2 lobed = sunLobe(vec3(0, 1, 0), view, sun, frame.groundRoughness);
  ROUNDED float mirrored = (0.04f * lobed.x + lobed.y) * lit;
  ROUNDED vec3 light = color * (sunLight * lit + openness * ambientUp) + sunLight * mirrored;
  return light;
}

// Adds the reflected light of the surroundings.
FUNCTION vec3 withAround(vec3 light, vec3 view, float openness) {
#ifdef GROUND_REFLECTIVE
  vec3 around = aroundGround(view);
#else
  vec3 around = ambientOnGround();
#endif
  ROUNDED vec3 sum = light + openness * sharesOfGround(view).mirrored * around;
  return sum;
}

#ifdef LAMPS
FUNCTION vec3 lampsOnGround(vec3 p, vec3 view) {
  LampLight lamps = lampLight(p, vec3(0, 1, 0), view, vec3(0.04f), frame.groundRoughness, 0.0f);
  ROUNDED vec3 light = sharesOfGround(view).matt * lamps.matt + lamps.mirror;
  return light;
}
#endif

FUNCTION vec3 lightOnGround(vec3 p, vec3 view, float fraction, float openness) {
  ROUNDED vec3 light = sunOnGround(view, fraction, openness);
#ifdef LAMPS
  vec3 normal = vec3(0, 1, 0), color = sharesOfGround(view).matt;
  LampLight lamps = lampLight(p, normal, view, vec3(0.04f), frame.groundRoughness, 0.0f);
  light = light + color * lamps.matt + lamps.mirror;
#endif
  return withAround(light, view, openness);
}

// Returns the light, premultiplied by the ground's alpha, and the alpha.
FUNCTION vec4 groundLight(vec3 p, vec3 view, float fraction, float openness) {
  vec3 light = lightOnGround(p, view, fraction, openness);
  float alpha = groundAlpha(p);
  ROUNDED vec3 faded = light * alpha;
  return vec4(faded, alpha);
}

#if defined REFLECTED && defined GROUND_REFLECTIVE
// Returns the change of the ground's light if the reflected ray hits objects in the picture instead of the
// surroundings. `met` holds the light of the objects times the coverage, and the coverage.
FUNCTION vec4 groundReflected(vec3 p, vec3 view, vec4 met, float openness) {
  ROUNDED vec3 change = sharesOfGround(view).mirrored * (vec3(met) - met.w * openness * aroundGround(view));
  ROUNDED vec3 faded = change * groundAlpha(p);
  return vec4(faded, 0.0f);
}
#endif
#endif
