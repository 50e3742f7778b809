// A surface's material as the driver's programs get it: uniforms, or (PASSED_FRAME) inputs from the vertex shader, see
// fragment_frame.glsl.
#include "draw/surface/lighting.glsl"
#ifdef PASSED_FRAME
flat in vec4 passedMaterial;
#define MATERIAL passedMaterial
#else
uniform float roughness;
uniform float metallic;
uniform float translucency;
#define MATERIAL vec3(roughness, metallic, translucency)
#endif

Look lookOf(vec3 base) {
  vec3 material = MATERIAL.xyz;
  return Look(base, material.x, material.y, material.z, 1.0);
}
