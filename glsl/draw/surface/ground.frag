// Colour times alpha, so that the tone map can lay it over the sky. Variants: SHADOWED, REFLECTIVE, LAMPS.
#include "draw/fragment_frame.glsl"
#include "draw/sky.glsl"
#include "draw/surface/shading.glsl"
#ifdef LAMPS
#include "draw/lights/lamps.glsl"
#endif
#ifdef SHADOWED
#include "draw/surface/shadow_read.glsl"
in vec3 place;
#endif
in vec3 worldPosition;
layout(location = 0) out vec4 radiance;

void main() {
  vec3 view = normalize(frame.eye.xyz - worldPosition);
  vec3 sun = frame.sunDirection.xyz;
  float lit = max(sun.y, 0.0);
#ifdef SHADOWED
  lit *= sunFraction(place);
#endif
  vec3 normal = vec3(0, 1, 0);
  float mirrored = 0.04 * sunLobe(normal, view, sun, frame.groundRoughness);
  vec3 light = frame.groundColor.rgb * (frame.sunLight.rgb * lit + frame.ambientUp.rgb) +
               frame.sunLight.rgb * (mirrored * lit);
#ifdef LAMPS
  LampLight lamps = lampLight(worldPosition, normal, view, frame.groundRoughness, 0.0);
  light += frame.groundColor.rgb * lamps.matt + 0.04 * lamps.mirror;
#endif
#ifdef REFLECTIVE
  vec2 weight = ambientLobe(frame.groundRoughness, abs(view.y));
  light += (0.04 * weight.x + weight.y) * mix(skyRadiance(abs(view.y)), frame.ambientUp.rgb, frame.groundRoughness);
#endif
  float far = clamp((distance(worldPosition.xz, frame.target.xz) - frame.groundFadeStart) * frame.perGroundFade, 0.0, 1.0);
  float alpha = 1.0 - far * far * (3.0 - 2.0 * far);
  radiance = vec4(light * alpha, alpha);
}
