// Clear coat, a smooth dielectric layer over a material. The material receives the light that the coat does not
// reflect. Compiles as GLSL and as C++.
#include "draw/surface/shading.glsl"

// Adds the coat. `below` is the light of the material under the coat. `mirrored` is the light that a black dielectric
// with the coat's roughness reflects.
FUNCTION vec3 coated(vec3 below, vec3 mirrored, float strength, float roughness, float nv) {
  vec2 share = ambientLobe(roughness, nv);
  ROUNDED float kept = 1.0f - strength * (0.04f * share.x + share.y);
  ROUNDED vec3 light = below * kept + mirrored * strength;
  return light;
}
