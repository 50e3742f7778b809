// What all lamps together give a surface. LAMPS, SHADOWED_LAMPS; TRANSLUCENT: some light comes from behind.
#include "draw/lights/lamp_list.glsl"
#include "draw/lights/point_light.glsl"
#include "draw/surface/shading.glsl"
#if SHADOWED_LAMPS > 0
#include "draw/lights/lamp_shadow.glsl"
#endif

struct LampLight {
  vec3 matt;    // irradiance / pi, for the albedo
  vec3 mirror;  // light of the lobes, for the colour F0
};

// Adds the share of number i, of which `fraction` reaches the place.
void addLamp(inout LampLight sum, int i, Arrival a, float fraction, vec3 normal, vec3 view, float alpha,
             float translucent) {
  float nl = dot(normal, a.towards);
  float lit = max(nl, 0.0);
#ifdef TRANSLUCENT
  float direct = mix(lit, max(-nl, 0.0), translucent);
#else
  float direct = lit;
#endif
  vec3 arriving = lampPower(i).rgb * (a.perArea * fraction);
  sum.matt += arriving * direct;
  sum.mirror += arriving * (lit * lobe(normal, view, a.towards, widenedAlpha(alpha, a.spread)));
}

LampLight lampLight(vec3 p, vec3 normal, vec3 view, float roughness, float translucent) {
  LampLight sum = LampLight(vec3(0), vec3(0));
  float alpha = roughAlpha(roughness);
  // Two loops: software drivers run both sides of a branch.
#if SHADOWED_LAMPS > 0
  for (int i = 0; i < SHADOWED_LAMPS; ++i) {
    Arrival a = arrivalAt(p, lampPlace(i), lampPower(i).w);
    float fraction = lampFraction(i, p - lampPlace(i).xyz, normal, dot(normal, a.towards));
    addLamp(sum, i, a, fraction, normal, view, alpha, translucent);
  }
#endif
#if SHADOWED_LAMPS < LAMPS
  for (int i = SHADOWED_LAMPS; i < LAMPS; ++i)
    addLamp(sum, i, arrivalAt(p, lampPlace(i), lampPower(i).w), 1.0, normal, view, alpha, translucent);
#endif
  return sum;
}
