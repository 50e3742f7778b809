// Sums the light of all lamps on a surface point. The LAMPS lamps are ordered. First are SHADOWED_LAMPS lamps with
// shadows, then the lamps without shadows or range, last RANGED_LAMPS lamps with a range and no shadow. SPOTS: some
// lamps have cones. AREAS: some are rectangles. RANGES: some have a range. TRANSLUCENT: light may also come through
// from behind.
#include "draw/lights/lamp_list.glsl"
#include "draw/lights/point_light.glsl"
#ifdef AREAS
#include "draw/lights/area_light.glsl"
#endif
#ifdef RANGES
#include "draw/lights/range.glsl"
#endif
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
  vec3 matt;    // diffuse part: irradiance / pi, to be multiplied by the albedo
  vec3 mirror;  // specular part: light of the lobes
#ifdef SHEEN
  vec3 sheen;   // light of the lobes of fabric fibres, to be multiplied by the sheen colour
#endif
};

// Adds the light of lamp i. `fraction` is the fraction of the lamp's light that reaches the point.
LampLight withLamp(LampLight sum, int i, Arrival a, float fraction, vec3 normal, vec3 view, vec3 f0, float alpha,
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
  ROUNDED vec2 lobed = lobe(normal, view, a.towards, widenedAlpha(alpha, a.spread)) * lit;
  ROUNDED vec3 mirror = sum.mirror + arriving * (f0 * lobed.x + lobed.y);
#ifdef SHEEN
  ROUNDED vec3 sheen = sum.sheen + arriving * (lit * sheenLobe(normal, view, a.towards, sheenRoughness_));
  return LampLight(matt, mirror, sheen);
#else
  return LampLight(matt, mirror);
#endif
}

// Returns the factor of lamp i's light at p: the fraction that the cone lets through in that direction, times the
// fraction for the range.
float sentBy(int i, Arrival a, vec3 p) {
  float sent = 1.0f;
#ifdef SPOTS
  sent = coneShare(a.towards, lampCone(i));
#endif
#ifdef RANGES
  ROUNDED vec3 way = lampPlace(i).xyz - p;
  ROUNDED float within = sent * rangeShare(dotted(way, way), lampAcross(i).w);
  sent = within;
#endif
  return sent;
}

#ifdef AREAS
// Adds the light of rectangular lamp i.
LampLight withRectangle(LampLight sum, int i, vec3 p, float fraction, vec3 normal, vec3 view, vec3 f0, float alpha,
                        float translucent) {
  vec3 middle = lampPlace(i).xyz, across = lampAcross(i).xyz, up = lampUp(i).xyz;
  float lit = rectangleShare(p, normal, middle, across, up);
#ifdef TRANSLUCENT
  ROUNDED float direct = lit + (rectangleShare(p, -normal, middle, across, up) - lit) * translucent;
#else
  float direct = lit;
#endif
  ROUNDED vec3 bright = lampPower(i).rgb * (lampUp(i).w * fraction);
  ROUNDED vec3 mirrored = 2.0f * dotted(normal, view) * normal - view;
  vec3 towards = towardsRectangle(p, mirrored, middle, across, up);
  ROUNDED vec2 lobed = rectangleLobe(normal, view, towards, lit, alpha, rectangleSpread(p, middle, across, up)) * lit;
  ROUNDED vec3 matt = sum.matt + bright * direct;
  ROUNDED vec3 mirror = sum.mirror + bright * (f0 * lobed.x + lobed.y);
#ifdef SHEEN
  ROUNDED vec3 sheen = sum.sheen + bright * (lit * sheenLobe(normal, view, towards, sheenRoughness_));
  return LampLight(matt, mirror, sheen);
#else
  return LampLight(matt, mirror);
#endif
}
#endif

// Adds the light of lamp i of any shape. `fraction` is the fraction of the lamp's light that is not in shadow.
LampLight withAny(LampLight sum, int i, vec3 p, Arrival a, float fraction, vec3 normal, vec3 view, vec3 f0, float alpha,
                  float translucent) {
  ROUNDED float reaching = fraction * sentBy(i, a, p);
#ifdef AREAS
  if (lampUp(i).w > 0.0f) return withRectangle(sum, i, p, reaching, normal, view, f0, alpha, translucent);
#endif
  return withLamp(sum, i, a, reaching, normal, view, f0, alpha, translucent);
}

#if RANGED_LAMPS > 0
#include "draw/lights/lamp_cells.glsl"
#endif

LampLight lampLight(vec3 p, vec3 normal, vec3 view, vec3 f0, float roughness, float translucent) {
#ifdef SHEEN
  LampLight sum = LampLight(vec3(0), vec3(0), vec3(0));
#else
  LampLight sum = LampLight(vec3(0), vec3(0));
#endif
  float alpha = roughAlpha(roughness);
  // Uses two loops instead of a branch in one loop, because software drivers execute both sides of a branch.
#if SHADOWED_LAMPS > 0
  for (int i = 0; i < SHADOWED_LAMPS; ++i) {
    Arrival a = arrivalAt(p, lampPlace(i), lampPower(i).w);
    ROUNDED vec3 from = p - lampPlace(i).xyz;
    float fraction = lampFraction(i, from, normal, dotted(normal, a.towards));
    sum = withAny(sum, i, p, a, fraction, normal, view, f0, alpha, translucent);
  }
#endif
#if SHADOWED_LAMPS < LAMPS - RANGED_LAMPS
  for (int i = SHADOWED_LAMPS; i < LAMPS - RANGED_LAMPS; ++i) {
    Arrival a = arrivalAt(p, lampPlace(i), lampPower(i).w);
    sum = withAny(sum, i, p, a, 1.0f, normal, view, f0, alpha, translucent);
  }
#endif
#if RANGED_LAMPS > 0
  int cell = lampCellAt(p);
  for (int word = 0; cell >= 0 && word < (RANGED_LAMPS + 31) / 32; ++word)
    for (uint left = texelFetch(lampCells, cell + word).x; left != 0u; left &= left - 1u) {
      int i = LAMPS - RANGED_LAMPS + 32 * word + findLSB(left);
      Arrival a = arrivalAt(p, lampPlace(i), lampPower(i).w);
      sum = withAny(sum, i, p, a, 1.0f, normal, view, f0, alpha, translucent);
    }
#endif
  return sum;
}
