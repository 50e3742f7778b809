// Sun, lamps and sky as light sources for rays. Defines: LAMPS, SHADOWED_LAMPS, SPOTS as in draw/lights/lamps.glsl;
// ENVIRONMENT.
#include "draw/sky.glsl"
#include "draw/exact/rays/facet.glsl"
#ifdef LAMPS
#include "draw/lights/lamp_list.glsl"
#include "draw/lights/point_light.glsl"
#ifdef AREAS
#include "draw/lights/area_light.glsl"
#endif
#ifdef RANGES
#include "draw/lights/range.glsl"
#endif
#if RANGED_LAMPS > 0
#include "draw/lights/lamp_cells.glsl"
#endif
#endif

// Returns the solid angle of the sun (sr); 0 for a sun without angular size.
float sunAngle() {
  precise float angle = 3.14159265f * frame.sunSpread * frame.sunSpread;
  return angle;
}

vec3 sunDirectionAt(float u, float v) {
  vec2 at = onDisc(u, v);
  precise vec2 aside = at * frame.sunSpread;
  precise vec3 to = frame.sunDirection.xyz + frame.lightRight.xyz * aside.x + frame.lightUp.xyz * aside.y;
  return unitOf(to);
}

bool isOnSun(vec3 direction) {
  float along = exactDot(direction, frame.sunDirection.xyz);
  precise vec2 aside = vec2(exactDot(direction, frame.lightRight.xyz), exactDot(direction, frame.lightUp.xyz));
  precise float square = aside.x * aside.x + aside.y * aside.y;
  precise float edge = frame.sunSpread * along;
  precise float edge2 = edge * edge;
  return along > 0.0f && square < edge2;
}

// Returns the sky's light from one direction. `factor` is the result of skyFactor(), from frame.ambient for diffuse
// surfaces to 1 for mirrors. `share` is the fraction of the surface's response that is its specular lobe. `all_` is the
// number of rays per steradian in this direction. An environment image is blurred so that gaps between few rays do not
// become noise (Colbert and Krivanek, "GPU-Based Importance Sampling", GPU Gems 3, 2007). A lobe of roughness r has the
// solid angle 4 pi alpha^2 with alpha = r^2. The blur is the roughness whose lobe is as large as the solid angle of one
// ray. The blur is at most half the roughness for specular surfaces (`share` 1) and 0.5 for diffuse ones (`share` 0).
// With more rays the image is sharper.
vec3 skyLight(vec3 direction, float factor, float roughness, float share, float all_) {
#ifdef ENVIRONMENT
  precise float maximum = 0.5f * (1.0f + (roughness - 1.0f) * share);
  precise float square = 0.07957747f * exactReciprocal(max(all_, 1e-6f));
  float blur = min(exactSqrt(exactSqrt(square)), maximum);
  precise vec3 light = environmentMirrored(direction, blur) * factor;
#else
  precise vec3 light = skyRadiance(direction.y) * factor;
#endif
  return light;
}
float skyFactor(float roughness, float share) {
#ifdef ENVIRONMENT
  precise float factor = frame.ambient + (1.0f - frame.ambient) * share;
#else
  precise float mirrored = 1.0f + (frame.ambient - 1.0f) * roughness;
  precise float factor = frame.ambient + (mirrored - frame.ambient) * share;
#endif
  return factor;
}

#ifdef LAMPS
#ifdef AREAS
// Returns the light of rectangular lamp i for a luminance of 1 / pi.
vec3 rectangleLightOn(Facet f, int i) {
  vec3 middle = lampPlace(i).xyz, across = lampAcross(i).xyz, up = lampUp(i).xyz;
  float lit = rectangleShare(f.place, f.normal, middle, across, up);
  precise float direct = lit;
  if (f.translucency > 0.0f) {
    float behind = rectangleShare(f.place, -f.normal, middle, across, up);
    direct = lit + (behind - lit) * f.translucency;
  }
  precise vec3 mirrored = 2.0f * exactDot(f.normal, f.view) * f.normal - f.view;
  vec3 towards = towardsRectangle(f.place, mirrored, middle, across, up);
  vec2 lobed = rectangleLobe(f.normal, f.view, towards, lit, f.alpha, rectangleSpread(f.place, middle, across, up));
#ifdef FINISHED
  precise vec3 light = f.matt * direct + mirroredBy(f, lobed) * lit;
  if (f.coat > 0.0f) {
    precise vec3 coatMirrored = 2.0f * exactDot(f.coatNormal, f.view) * f.coatNormal - f.view;
    vec3 coatTowards = towardsRectangle(f.place, coatMirrored, middle, across, up);
    float coatLit = rectangleShare(f.place, f.coatNormal, middle, across, up);
    vec2 coatLobed = rectangleLobe(f.coatNormal, f.view, coatTowards, coatLit, f.coatAlpha, rectangleSpread(f.place, middle, across, up));
    light = light + f.coat * coatLit * (0.04f * coatLobed.x + coatLobed.y);
  }
  precise vec3 toMiddle = middle - f.place;
  if (max(f.fibres.x, max(f.fibres.y, f.fibres.z)) > 0.0f) light = light + f.fibres * (lit * sheenLobe(f.normal, f.view, unitOf(toMiddle), f.fibreRoughness));
  light = light * lampUp(i).w;
#else
  precise vec3 light = (f.matt * direct + mirroredBy(f, lobed) * lit) * lampUp(i).w;
#endif
  return light;
}
#endif

// Returns the light of lamp i, without shadow, that the facet reflects to the viewer. The facet's lobe is widened by
// the lamp's size (draw/lights/point_light.glsl).
vec3 lampLightOn(Facet f, int i) {
  Arrival a = arrivalAt(f.place, lampPlace(i), lampPower(i).w);
  float nl = exactDot(f.normal, a.towards);
  precise float share = a.perArea;
#ifdef RANGES
  precise vec3 way = f.place - lampPlace(i).xyz;
  float kept = rangeShare(exactDot(way, way), lampAcross(i).w);
  share = share * kept;
#endif
#ifdef AREAS
  if (lampUp(i).w > 0.0f) {
#ifndef RANGES
    const float kept = 1.0f;
#endif
    precise vec3 bright = lampPower(i).rgb * kept * rectangleLightOn(f, i);
    return bright;
  }
#endif
#ifdef SPOTS
  share = share * coneShare(a.towards, lampCone(i));
#endif
  float lit = max(nl, 0.0f);
  vec2 lobed = lobe(f.normal, f.view, a.towards, widenedAlpha(f.alpha, a.spread));
#ifdef FINISHED
  precise vec3 of = f.matt * mattCosine(f, nl) + mirroredBy(f, lobed) * lit +
                    overLight(f, a.towards, widenedAlpha(f.coatAlpha, a.spread));
#else
  precise vec3 of = f.matt * mattCosine(f, nl) + mirroredBy(f, lobed) * lit;
#endif
  precise vec3 light = lampPower(i).rgb * share * of;
  return light;
}

// Returns a sampled point of lamp i: on the rectangle of a rectangular lamp, or on a disc with the radius of the lamp's
// ball that faces p.
vec3 lampPlaceAt(vec3 p, int i, float u, float v) {
  vec4 ball = lampPlace(i);
#ifdef AREAS
  if (lampUp(i).w > 0.0f) {
    precise vec2 part = 2.0f * vec2(u, v) - 1.0f;
    precise vec3 place = ball.xyz + lampAcross(i).xyz * part.x + lampUp(i).xyz * part.y;
    return place;
  }
#endif
  precise vec3 to = ball.xyz - p;
  precise float square = max(exactDot(to, to), 1e-12f);
  precise vec3 towards = to * exactInverseSqrt(square);
  precise vec2 at = onDisc(u, v) * ball.w;
  precise vec3 q = ball.xyz + rightOf(towards) * at.x + upOf(towards) * at.y;
  return q;
}

// Returns the length of the shadow ray from p in `direction` to a point of lamp i at the distance `way`. The ray ends
// where it enters the lamp's ball, because nothing inside the ball casts a shadow.
float lampReach(vec3 p, int i, vec3 direction, float way) {
  vec4 ball = lampPlace(i);
  precise vec3 to = ball.xyz - p;
  float along = exactDot(to, direction);
  precise float half2 = ball.w * ball.w - (exactDot(to, to) - along * along);
  precise float entry = along - exactSqrt(max(half2, 0.0f));
  precise float whole = way * 0.9999f;
  precise float reach = min(whole, half2 > 0.0f ? entry : whole);
  return max(reach, 0.0f);
}
#endif

// Returns the light of all lamps that cast no shadows.
vec3 openLamps(Facet f) {
  precise vec3 sum = vec3(0);
#if defined LAMPS
#if SHADOWED_LAMPS < LAMPS - RANGED_LAMPS
  for (int i = SHADOWED_LAMPS; i < LAMPS - RANGED_LAMPS; ++i) sum = sum + lampLightOn(f, i);
#endif
#if RANGED_LAMPS > 0
  int cell = lampCellAt(f.place);
  for (int word = 0; cell >= 0 && word < (RANGED_LAMPS + 31) / 32; ++word)
    for (uint left = texelFetch(lampCells, cell + word).x; left != 0u; left &= left - 1u)
      sum = sum + lampLightOn(f, LAMPS - RANGED_LAMPS + 32 * word + findLSB(left));
#endif
#endif
  return sum;
}

// Returns the brightness of the light of all lamps that cast shadows.
float brightnessOfLamps(Facet f) {
  precise float all_ = 0.0f;
#if defined LAMPS
#if SHADOWED_LAMPS > 0
  for (int i = 0; i < SHADOWED_LAMPS; ++i) all_ = all_ + brightnessOf(lampLightOn(f, i));
#endif
#endif
  return all_;
}

// A lamp with shadows, chosen with a probability proportional to its light. Its light is divided by that probability.
struct Chosen {
  int lamp;  // index of the lamp; -1 if no lamp gives light
  vec3 light;
};
Chosen chosenLamp(Facet f, float u) {
  Chosen chosen = Chosen(-1, vec3(0));
#if defined LAMPS
#if SHADOWED_LAMPS > 0
  precise float all_ = 0.0f;
  for (int i = 0; i < SHADOWED_LAMPS; ++i) all_ = all_ + brightnessOf(lampLightOn(f, i));
  precise float wanted = u * all_;
  precise float before = 0.0f;
  for (int i = 0; i < SHADOWED_LAMPS; ++i) {
    vec3 light = lampLightOn(f, i);
    float weight = brightnessOf(light);
    precise float after = before + weight;
    bool here = weight > 0.0f && (wanted < after || chosen.lamp < 0);
    precise vec3 counts = light * (all_ * exactReciprocal(max(weight, 1e-25f)));
    if (here && (chosen.lamp < 0 || wanted >= before)) {
      chosen.lamp = i;
      chosen.light = counts;
    }
    before = after;
  }
#endif
#endif
  return chosen;
}
