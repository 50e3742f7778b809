// Light that a metal/rough surface under sun, sky and lamps sends to the eye. Variants: TRANSLUCENT, REFLECTIVE, SHADOW, SKIN, LAMPS.
#include "draw/sky.glsl"
#include "draw/surface/shading.glsl"
#include "draw/surface/shadow_read.glsl"
#ifdef LAMPS
#include "draw/lights/lamps.glsl"
#endif
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

#ifdef REFLECTIVE
vec3 mattPart(vec3 base) {
  return base * (1.0 - metallic);
}
vec3 mirrorPart(vec3 base) {
  return mix(vec3(0.04), base, metallic);
}
#else
vec3 mattPart(vec3 base) {
  return base;
}
vec3 mirrorPart(vec3 base) {
  return vec3(0.04);
}
#endif

// `fraction` of the sun reaches the place; `normal` points to the viewer's side.
vec3 surfaceLight(vec3 base, vec3 normal, vec3 view, float fraction) {
  vec3 sun = frame.sunDirection.xyz;
  float nl = dot(normal, sun);
  float lit = max(nl, 0.0) * fraction;
  vec3 matt = mattPart(base);
  vec3 mirror = mirrorPart(base);
  float lobed = sunLobe(normal, view, sun, roughness) * lit;
#ifdef TRANSLUCENT
  float direct = mix(lit, max(-nl, 0.0) * fraction, translucency);
  vec3 ambient = mix(ambientLight(normal.y), ambientLight(-normal.y), translucency);
#else
  float direct = lit;
  vec3 ambient = ambientLight(normal.y);
#endif
  vec3 light = matt * (frame.sunLight.rgb * direct + openness * ambient) + mirror * (frame.sunLight.rgb * lobed);
#ifdef REFLECTIVE
  float nv = abs(dot(normal, view));
  float height = 2.0 * dot(normal, view) * normal.y - view.y;  // of the mirrored direction
  vec2 weight = ambientLobe(roughness, nv);
  light += openness * (mirror * weight.x + weight.y) * mix(skyRadiance(height), ambientLight(height), roughness);
#endif
  return light;
}

// The same with the scene's lamps; p: where they are looked up from.
vec3 allLight(vec3 base, vec3 p, vec3 normal, vec3 view, float fraction) {
  vec3 light = surfaceLight(base, normal, view, fraction);
#ifdef LAMPS
  LampLight lamps = lampLight(p, normal, view, roughness, translucency);
  light += mattPart(base) * lamps.matt + mirrorPart(base) * lamps.mirror;
#endif
  return light;
}
