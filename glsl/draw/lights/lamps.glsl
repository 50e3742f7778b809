// What all lamps together give a surface. LAMPS, SHADOWED_LAMPS; SPOTS: some have cones; TRANSLUCENT: some light comes from behind.
#include "draw/lights/lamp_list.glsl"
#include "draw/lights/point_light.glsl"
#include "draw/surface/shading.glsl"
#if SHADOWED_LAMPS > 0
#include "draw/lights/faces.glsl"
#ifdef EXACT_PICTURE
#include "draw/exact/shadows/lamp_maps.glsl"
#else
#include "draw/lights/lamp_shadow.glsl"
#endif
#endif

struct LampLight {
  vec3 matt;    // irradiance / pi, for the albedo
  vec3 mirror;  // light of the lobes, for the colour F0
#ifdef SHEEN
  vec3 sheen;   // of those of fibres, for their colour
#endif
};

// Adds the share of number i, of which `fraction` reaches the place.
LampLight withLamp(LampLight sum, int i, Arrival a, float fraction, vec3 normal, vec3 view, float alpha,
                   float translucent) {
  float nl = dotted(normal, a.towards);
  float lit = max(nl, 0.0f);
#ifdef TRANSLUCENT
  ROUNDED float direct = lit + (max(-nl, 0.0f) - lit) * translucent;
#else
  float direct = lit;
#endif
  ROUNDED vec3 arriving = lampPower(i).rgb * (a.perArea * fraction);
  ROUNDED vec3 matt = sum.matt + arriving * direct;
  ROUNDED vec3 mirror = sum.mirror + arriving * (lit * lobe(normal, view, a.towards, widenedAlpha(alpha, a.spread)));
#ifdef SHEEN
  ROUNDED vec3 sheen = sum.sheen + arriving * (lit * sheenLobe(normal, view, a.towards, sheenRoughness_));
  return LampLight(matt, mirror, sheen);
#else
  return LampLight(matt, mirror);
#endif
}

// What lamp i sends into the direction of the place.
float sentBy(int i, Arrival a) {
#ifdef SPOTS
  return coneShare(a.towards, lampCone(i));
#else
  return 1.0f;
#endif
}

LampLight lampLight(vec3 p, vec3 normal, vec3 view, float roughness, float translucent) {
#ifdef SHEEN
  LampLight sum = LampLight(vec3(0), vec3(0), vec3(0));
#else
  LampLight sum = LampLight(vec3(0), vec3(0));
#endif
  float alpha = roughAlpha(roughness);
  // Two loops: software drivers run both sides of a branch.
#if SHADOWED_LAMPS > 0
  for (int i = 0; i < SHADOWED_LAMPS; ++i) {
    Arrival a = arrivalAt(p, lampPlace(i), lampPower(i).w);
    ROUNDED vec3 from = p - lampPlace(i).xyz;
    ROUNDED float fraction = lampFraction(i, from, normal, dotted(normal, a.towards)) * sentBy(i, a);
    sum = withLamp(sum, i, a, fraction, normal, view, alpha, translucent);
  }
#endif
#if SHADOWED_LAMPS < LAMPS
  for (int i = SHADOWED_LAMPS; i < LAMPS; ++i) {
    Arrival a = arrivalAt(p, lampPlace(i), lampPower(i).w);
    sum = withLamp(sum, i, a, sentBy(i, a), normal, view, alpha, translucent);
  }
#endif
  return sum;
}
