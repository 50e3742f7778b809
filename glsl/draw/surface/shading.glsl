// Metal/rough reflection model. Light is irradiance / pi, so a white matt surface that faces the light has a radiance
// of the same value. Compiles as GLSL and as C++.
#ifndef DRAW_SHADING
#define DRAW_SHADING
#include "draw/arithmetic.glsl"

// Returns (1 - cosine)^5 of Schlick's Fresnel term ("An Inexpensive BRDF Model for Physically-based Rendering", 1994).
FUNCTION float schlickPart(float cosine) {
  ROUNDED float rest = 1.0f - cosine;
  float left = clamp(rest, 0.0f, 1.0f);
  ROUNDED float square = left * left;
  ROUNDED float fifth = square * square * left;
  return fifth;
}

// Returns 1 / (4 V) for height-correlated Smith shadowing of GGX: V = G2 / (4 nl nv) (Heitz, "Understanding the
// Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 2014).
FUNCTION float smithUnder(float nl, float nv, float alpha2) {
  ROUNDED float rest = 1.0f - alpha2;
  ROUNDED float seen = nv * nv * rest + alpha2;
  ROUNDED float lit = nl * nl * rest + alpha2;
  ROUNDED float under = 0.5f * (nl * root(seen) + nv * root(lit));
  return under;
}

// Returns x and y of the specular lobe F0 x + y: pi D V of GGX (Walter et al., "Microfacet Models for Refraction
// through Rough Surfaces", EGSR 2007) with Schlick's Fresnel term. `nl` is the cosine between normal and light. `lower`
// is the factor on the lobe. The value is limited to 60, because sharper highlights are smaller than pixels and would
// flicker.
FUNCTION vec2 lowerLobe(vec3 normal, vec3 view, vec3 light, float nl, float alpha, float lower) {
  ROUNDED vec3 sum = view + light;
  vec3 halfway = unitOf(sum);
  float nh = max(dotted(normal, halfway), 0.0f), nv = max(dotted(normal, view), 1e-3f);
  ROUNDED float alpha2 = alpha * alpha;
  ROUNDED float d = nh * nh * (alpha2 - 1.0f) + 1.00001f;
  ROUNDED float under = 4.0f * d * d * smithUnder(max(nl, 1e-3f), nv, alpha2);
  ROUNDED float value = lower * alpha2 * inverse(max(under, 1e-20f));
  float maximum = min(value, 60.0f);
  ROUNDED float white = maximum * schlickPart(dotted(light, halfway));
  ROUNDED float colored = maximum - white;
  return vec2(colored, white);
}
FUNCTION vec2 lobe(vec3 normal, vec3 view, vec3 light, float alpha) {
  return lowerLobe(normal, view, light, dotted(normal, light), alpha, 1.0f);
}

FUNCTION float roughAlpha(float roughness) {
  ROUNDED float alpha = roughness * roughness;
  return max(alpha, 0.002f);
}

FUNCTION vec2 sunLobe(vec3 normal, vec3 view, vec3 sun, float roughness) {
  return lobe(normal, view, sun, roughAlpha(roughness));
}

// Returns x and y of F0 x + y, the fraction of ambient light that the lobe reflects. The formulas fit the integral of
// the GGX lobe over the hemisphere, including the loss by shadowing between facets. The error is below 0.03 (0.04 for
// nv < 0.2, 0.06 for nv < 0.1); the error of y is below 0.006 for nv > 0.5.
FUNCTION vec2 ambientLobe(float roughness, float nv) {
  ROUNDED float alpha = roughness * roughness;
  ROUNDED float tilt = 1.0f - nv;
  ROUNDED float tilt2 = tilt * tilt;
  ROUNDED float rough = 1.0f + alpha * (25.46f * alpha + 12.16f * tilt2);
  ROUNDED float y = tilt2 * tilt * (tilt2 + 0.473f * roughness) * inverse(rough);
  ROUNDED float straight = 2.607f - 5.241f * roughness + 3.265f * alpha;
  ROUNDED float slope = -4.156f + 10.618f * roughness - 6.316f * alpha;
  ROUNDED float wide = nv + 0.1419f * alpha + 1e-6f;
  ROUNDED float lost = alpha * nv * (straight + slope * nv) * inverse(wide);
  ROUNDED float x = 1.0f - max(lost, 0.0f) - y;
  return vec2(x, y);
}

// Fractions of light that a surface reflects. The fraction `matt` is reflected in all directions. `mirrored` is the
// fraction of the surroundings' light that the lobe reflects, and `mirror` is the lobe's F0. The matt part is what the
// lobe of a dielectric does not reflect, so a white surface reflects all light.
struct Shares {
  vec3 matt;
  vec3 mirror;
  vec3 mirrored;
};
FUNCTION Shares barycentricWeights(vec3 base, float roughness, float metallic, float nv) {
  vec2 weight = ambientLobe(roughness, abs(nv));
  ROUNDED float lost = 0.04f * weight.x + weight.y;
  ROUNDED float kept = (1.0f - metallic) * (1.0f - clamp(lost, 0.0f, 1.0f));
  ROUNDED vec3 matt = base * kept;
  vec3 mirror = blend(vec3(0.04f), base, metallic);
  ROUNDED vec3 mirrored = mirror * weight.x + weight.y;
  Shares shares;
  shares.matt = matt;
  shares.mirror = mirror;
  shares.mirrored = mirrored;
  return shares;
}
#endif
