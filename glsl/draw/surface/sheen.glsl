// Sheen of fabric fibres: the lobe of Estevez and Kulla, "Production friendly microfacet sheen BRDF" (2017), with the
// visibility term of Neubelt and Pettineo ("Crafting a next-gen material pipeline", 2013), as in glTF's
// KHR_materials_sheen. Light is in the units of shading.glsl. Compiles as GLSL and as C++.
#ifndef DRAW_SHEEN
#define DRAW_SHEEN
#include "draw/arithmetic.glsl"

// Returns pi D V with D = (2 + 1/a) sin^(1/a) / (2 pi), V = 1 / (4 (nl + nv - nl nv)) and a = roughness^2. The colour
// is not included.
FUNCTION float sheenLobe(vec3 normal, vec3 view, vec3 light, float roughness) {
  ROUNDED vec3 sum = view + light;
  vec3 halfway = unitOf(sum);
  float nh = dotted(normal, halfway);
  float nl = max(dotted(normal, light), 0.0f);
  float nv = max(abs(dotted(normal, view)), 0.02f);
  ROUNDED float alpha = roughness * roughness;
  float perAlpha = inverse(alpha);
  ROUNDED float sine2 = max(1.0f - nh * nh, 1e-12f);
  ROUNDED float power = 0.5f * perAlpha * logarithmOfTwo(sine2);
  ROUNDED float under = 8.0f * (nl + nv - nl * nv);
  ROUNDED float value = (2.0f + perAlpha) * powerOfTwo(power) * inverse(under);
  return value;
}

// Returns the fraction of uniform ambient light that the lobe reflects to the eye. The formula was fitted for simreel;
// its mean error is 0.02 for roughness 0.1 to 1. The result is limited to 1; the lobe itself exceeds 1 at grazing
// angles.
FUNCTION float sheenAlbedo(float roughness, float nv) {
  float r = roughness;
  ROUNDED float a = ((2.173536f * r - 3.036944f) * r + 0.055008f) * r + 0.302396f;
  ROUNDED float b = ((-1.885571f * r + 1.000715f) * r + 3.622464f) * r - 4.270027f;
  ROUNDED float c = ((36.00897f * r - 81.89815f) * r + 61.18603f) * r - 14.99605f;
  ROUNDED float natural = ((c * nv + b) * nv + a) * 1.44269504f;
  return min(powerOfTwo(natural), 1.0f);
}

// Adds the fibres. `below` is the light of the material under the fibres, which is reduced by the light that the fibres
// reflect. `direct` is the light of the fibres' lobes. `around` is the ambient light.
FUNCTION vec3 underFibres(vec3 below, vec3 direct, vec3 around, vec3 color, float roughness, float nv) {
  float albedo = sheenAlbedo(roughness, nv);
  ROUNDED float kept = 1.0f - max(color.x, max(color.y, color.z)) * albedo;
  ROUNDED vec3 light = below * kept + color * (direct + around * albedo);
  return light;
}
#endif
