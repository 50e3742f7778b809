// Light that a metal/rough surface under sun and sky sends to the eye. Variants: TRANSLUCENT, REFLECTIVE, SHADOW, SKIN.
#include "draw/sky.glsl"
#include "draw/surface/shading.glsl"
#include "draw/surface/shadow_read.glsl"
#ifdef SKIN  // both vary from place to place
float roughness = 1.0;
float openness = 1.0;  // fraction of the surroundings' light that gets into a cavity
#else
const float openness = 1.0;
#endif
#ifdef PASSED_FRAME  // by the vertex shader: see fragment_frame.glsl
flat in vec4 passedMaterial;
#ifndef SKIN
float roughness = passedMaterial.x;
#endif
float metallic = passedMaterial.y;
float translucency = passedMaterial.z;
#else
#ifndef SKIN
uniform float roughness;
#endif
uniform float metallic;
uniform float translucency;
#endif

// `fraction` of the sun reaches the place; `normal` points to the viewer's side.
vec3 surfaceLight(vec3 base, vec3 normal, vec3 view, float fraction) {
  vec3 sun = frame.sunDirection.xyz;
  float nl = dot(normal, sun);
  float lit = max(nl, 0.0) * fraction;
#ifdef REFLECTIVE
  vec3 matt = base * (1.0 - metallic);
  vec3 mirror = mix(vec3(0.04), base, metallic);
#else
  vec3 matt = base;
  vec3 mirror = vec3(0.04);
#endif
  float lobe = sunLobe(normal, view, sun, roughness) * lit;
#ifdef TRANSLUCENT
  float direct = mix(lit, max(-nl, 0.0) * fraction, translucency);
  vec3 ambient = mix(ambientLight(normal.y), ambientLight(-normal.y), translucency);
#else
  float direct = lit;
  vec3 ambient = ambientLight(normal.y);
#endif
  vec3 light = matt * (frame.sunLight.rgb * direct + openness * ambient) + mirror * (frame.sunLight.rgb * lobe);
#ifdef REFLECTIVE
  float nv = abs(dot(normal, view));
  float height = 2.0 * dot(normal, view) * normal.y - view.y;  // of the mirrored direction
  vec2 weight = ambientLobe(roughness, nv);
  light += openness * (mirror * weight.x + weight.y) * mix(skyRadiance(height), ambientLight(height), roughness);
#endif
  return light;
}
