// Light of the ground times its alpha, and alpha: it fades out far from what the camera looks at. `fraction` of the sun
// reaches the place, and of what is around it `openness`. Variants: REFLECTIVE, LAMPS, REFLECTED as in lighting.glsl (then there is no
// alpha). Compiles as GLSL and as C++.
#include "draw/sky.glsl"
#include "draw/surface/shading.glsl"
#ifdef LAMPS
#include "draw/lights/lamps.glsl"
#endif

FUNCTION vec4 groundLight(vec3 p, vec3 view, float fraction, float openness) {
  vec3 sun = vec3(frame.sunDirection), sunLight = vec3(frame.sunLight), color = vec3(frame.groundColor);
  ROUNDED float lit = max(sun.y, 0.0f) * fraction;
  vec3 normal = vec3(0, 1, 0);
#ifdef ENVIRONMENT
  vec3 ambientUp = ambientOn(normal);
#else
  vec3 ambientUp = vec3(frame.ambientUp);
#endif
  ROUNDED float mirrored = 0.04f * sunLobe(normal, view, sun, frame.groundRoughness) * lit;
  ROUNDED vec3 light = color * (sunLight * lit + openness * ambientUp) + sunLight * mirrored;
#ifdef LAMPS
  LampLight lamps = lampLight(p, normal, view, frame.groundRoughness, 0.0f);
  light = light + color * lamps.matt + 0.04f * lamps.mirror;
#endif
#ifdef REFLECTIVE
  vec2 weight = ambientLobe(frame.groundRoughness, abs(view.y));
#ifdef ENVIRONMENT
  vec3 around = environmentMirrored(vec3(-view.x, abs(view.y), -view.z), frame.groundRoughness);
#else
  vec3 around = blend(skyRadiance(abs(view.y)), ambientUp, frame.groundRoughness);
#endif
#ifdef REFLECTED
  vec3 along = vec3(-view.x, abs(view.y), -view.z);
  vec4 met = lightMet(p, along, view, frame.groundRoughness);
  light = (0.04f * weight.x + weight.y) * (vec3(met) - met.w * openness * around);
#else
  light = light + openness * (0.04f * weight.x + weight.y) * around;
#endif
#endif
  ROUNDED vec3 aside = p - vec3(frame.target);
  ROUNDED float distance2 = aside.x * aside.x + aside.z * aside.z;
  ROUNDED float far = (root(distance2) - frame.groundFadeStart) * frame.perGroundFade;
  ROUNDED float alpha = 1.0f - smoothed(clamp(far, 0.0f, 1.0f));
  ROUNDED vec3 faded = light * alpha;
#ifdef REFLECTED
  return vec4(faded, 0.0f);
#else
  return vec4(faded, alpha);
#endif
}
