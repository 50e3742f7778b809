// Material of a surface for the driver's rasterizer. The values are uniforms or, with PASSED_FRAME, inputs from the
// vertex shader (fragment_frame.glsl).
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
