// A clear coat: a smooth dielectric over everything else, which gets what the coat does not mirror. Compiles as GLSL and as C++.
#include "draw/surface/shading.glsl"

// `below`: light from under the coat; `mirrored`: what a black dielectric of the coat's roughness sends.
FUNCTION vec3 coated(vec3 below, vec3 mirrored, float strength, float roughness, float nv) {
  vec2 share = ambientLobe(roughness, nv);
  ROUNDED float kept = 1.0f - strength * (0.04f * share.x + share.y);
  ROUNDED vec3 light = below * kept + mirrored * strength;
  return light;
}
