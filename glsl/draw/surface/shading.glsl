// Metal/rough reflection. Light is irradiance / pi, so a white matt surface facing it has its radiance. Compiles as GLSL
// and as C++.
#ifndef DRAW_SHADING
#define DRAW_SHADING
#include "draw/arithmetic.glsl"

// pi times the GGX lobe D V with V F of Karis' fit for mobile GPUs (course notes, SIGGRAPH 2015,
// "Optimizing PBR for mobile"), without the colour F0.
FUNCTION float lobe(vec3 normal, vec3 view, vec3 light, float alpha) {
  ROUNDED vec3 sum = view + light;
  vec3 halfway = unitOf(sum);
  float nh = max(dotted(normal, halfway), 0.0f);
  float lh = dotted(light, halfway);
  ROUNDED float lh2 = lh * lh;
  ROUNDED float d = nh * nh * (alpha * alpha - 1.0f) + 1.00001f;
  ROUNDED float under = d * d * max(lh2, 0.1f) * (alpha * 4.0f + 2.0f);
  ROUNDED float value = alpha * alpha * inverse(under);
  return min(value, 60.0f);
}

FUNCTION float roughAlpha(float roughness) {
  ROUNDED float alpha = roughness * roughness;
  return max(alpha, 0.002f);
}

FUNCTION float sunLobe(vec3 normal, vec3 view, vec3 sun, float roughness) {
  return lobe(normal, view, sun, roughAlpha(roughness));
}

// Fraction of ambient light mirrored: F0 * x + y (Lazarov's fit in Karis' form, same notes).
FUNCTION vec2 ambientLobe(float roughness, float nv) {
  ROUNDED float r = 1.0f - roughness;
  ROUNDED float faint = 0.0425f - roughness * 0.0275f;
  ROUNDED float middle = 1.04f - roughness * 0.572f;
  ROUNDED float last = roughness * 0.022f - 0.04f;
  ROUNDED float fall = -9.28f * nv;
  ROUNDED float r2 = r * r;
  ROUNDED float a = min(r2, powerOfTwo(fall)) * r + faint;
  ROUNDED float x = -1.04f * a + middle;
  ROUNDED float y = 1.04f * a + last;
  return vec2(x, y);
}
#endif
