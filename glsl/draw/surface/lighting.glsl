// Light that a metal/rough surface under sun, sky and lamps reflects to the eye. Compiles as GLSL and as C++. Defines:
// TRANSLUCENT, REFLECTIVE, LAMPS.
// SHEEN: the surface has fabric fibres with the colour sheen_ and the roughness sheenRoughness_.
// JOINED: one kernel shades several surfaces, only some of which are REFLECTIVE; `mirrors` is true for these.
// SHOWN: outputs a value of draw/surface/overlay.glsl instead of light.
// REFLECTED: outputs the change of the light if reflected rays hit objects of the picture, and with GROUND_BELOW the
// ground, instead of the surroundings (draw/exact/reflections).
#include "draw/sky.glsl"
#include "draw/surface/shading.glsl"
#ifdef SHOWN
#include "draw/surface/overlay.glsl"
#endif
#ifdef SHEEN
#include "draw/surface/sheen.glsl"
#endif
#ifdef LAMPS
#include "draw/lights/lamps.glsl"
#endif
#if defined REFLECTIVE && defined GROUND_BELOW
#include "draw/exact/reflections/mirrored_ground.glsl"
#endif

// Material properties at a point of a surface.
struct Look {
  vec3 base;           // base colour, linear RGB
  float roughness;     // roughness, 0 to 1
  float metallic;      // metallic, 0 to 1
  float translucency;  // fraction of light that comes through from behind
  float openness;      // fraction of ambient light that reaches the point, below 1 in cavities
};

FUNCTION Shares sharesOfLook(Look look, float nv) {
#ifdef REFLECTIVE
  return barycentricWeights(look.base, look.roughness, look.metallic, nv);
#else
  return barycentricWeights(look.base, look.roughness, 0.0f, nv);
#endif
}

// Returns the light of sun and sky. `fraction` of the sunlight reaches the point; `normal` points to the viewer's side.
// GROUND_BELOW: reflections also show the ground.
FUNCTION vec3 surfaceLight(Look look, Shares shares, vec3 p, vec3 normal, vec3 view, float fraction) {
  vec3 sun = vec3(frame.sunDirection), sunLight = vec3(frame.sunLight);
  float nl = dotted(normal, sun);
  ROUNDED float lit = max(nl, 0.0f) * fraction;
  ROUNDED vec2 lobed = sunLobe(normal, view, sun, look.roughness) * lit;
#ifdef TRANSLUCENT
  // The offset of the shadow map's receiver lets sunlight into the narrow folds of a translucent sheet, whose inner sides
  // the sun grazes. The matt light there equals the light through the sheet, but the lobe would be a pale rim, so it fades.
  ROUNDED float twice = 2.0f * nl;
  float steep = look.translucency > 0.0f ? clamp(twice, 0.0f, 1.0f) : 1.0f;
  lobed = lobed * (steep * steep);
  ROUNDED float behind = max(-nl, 0.0f) * fraction;
  ROUNDED float direct = lit + (behind - lit) * look.translucency;
  vec3 front = ambientOn(normal);
  vec3 ambient = blend(front, ambientOn(-normal), look.translucency);
#else
  float direct = lit;
  vec3 front = ambientOn(normal);
  vec3 ambient = front;
#endif
  ROUNDED vec3 light =
      shares.matt * (sunLight * direct + look.openness * ambient) + (shares.mirror * lobed.x + lobed.y) * sunLight;
#ifdef REFLECTIVE
#ifdef JOINED
  if (!mirrors) {
    light = light + look.openness * shares.mirrored * front;
    return light;
  }
#endif
  float nv = dotted(normal, view);
  ROUNDED vec3 direction = 2.0f * nv * normal - view;
  vec3 around = skyMirrored(direction, look.roughness);
  light = light + look.openness * shares.mirrored * around;
#ifdef GROUND_BELOW
  GroundMirrored below = groundMirrored(p, direction, look.roughness, look.openness);
  IF_ANY(below.counts > 0.0f)
    light = light + below.counts * shares.mirrored * (groundInSun(below, direction) - look.openness * around);
#endif
#else
  light = light + look.openness * shares.mirrored * front;
#endif
  return light;
}

#ifdef REFLECTED
// Returns (F0 x + y) (met - surroundings) for the light `met` of the reflected ray, weighted by its coverage, plus the
// lamps' light on the reflected ground.
FUNCTION vec3 reflectedChange(Look look, vec3 p, vec3 normal, vec3 view) {
  vec3 light = vec3(0);
#ifdef REFLECTIVE
#ifdef JOINED
  bool smooth_ = mirrors && look.roughness < mirrorRough;
#else
  bool smooth_ = look.roughness < mirrorRough;
#endif
  float nv = dotted(normal, view);
  ROUNDED vec3 direction = 2.0f * nv * normal - view;
  vec4 met = vec4(0);
#ifdef GROUND_BELOW
  float ground = groundAlong(p, direction);
#else
  const float ground = -1.0f;
#endif
  IF_ANY(smooth_) met = lightMet(p, direction, ground, view, look.roughness);
#ifdef GROUND_BELOW
  GroundMirrored below = groundMirrored(p, direction, look.roughness, look.openness);
#endif
#if defined GROUND_BELOW && defined LAMPS
  bool changes = met.w > 0.0f || below.counts > 0.0f;
#else
  bool changes = met.w > 0.0f;
#endif
  IF_ANY(changes) {
    ROUNDED vec3 around = look.openness * skyMirrored(direction, look.roughness), more = vec3(0.0f);
#ifdef GROUND_BELOW
#ifdef LAMPS
    more = below.counts * lampsOnMirrored(below, direction);
#endif
    around = around + below.counts * (groundInSun(below, direction) - around) + more;
#endif
    ROUNDED vec3 change = sharesOfLook(look, nv).mirrored * (more + vec3(met) - met.w * around);
    light = change;
  }
#endif
  return light;
}
#endif

// Returns the light of sun, sky and lamps. p is the position at which the lamps' light is computed.
FUNCTION vec3 allLight(Look look, vec3 p, vec3 normal, vec3 view, float fraction) {
#ifdef SHOWN
  return shownValue(look.base, normal, view);
#endif
#ifdef REFLECTED
  vec3 light = reflectedChange(look, p, normal, view);
#ifdef SHEEN
  light = underFibres(light, vec3(0), vec3(0), sheen_, sheenRoughness_, abs(dotted(normal, view)));
#endif
  return light;
#else
  Shares shares = sharesOfLook(look, dotted(normal, view));
  vec3 light = surfaceLight(look, shares, p, normal, view, fraction);
#ifdef LAMPS
  LampLight lamps = lampLight(p, normal, view, shares.mirror, look.roughness, look.translucency);
  ROUNDED vec3 sum = light + shares.matt * lamps.matt + lamps.mirror;
  light = sum;
#endif
#ifdef SHEEN
  ROUNDED float lit = max(dotted(normal, vec3(frame.sunDirection)), 0.0f) * fraction;
  ROUNDED vec3 fibres = vec3(frame.sunLight) * (lit * sheenLobe(normal, view, vec3(frame.sunDirection), sheenRoughness_));
#ifdef LAMPS
  fibres = fibres + lamps.sheen;
#endif
  ROUNDED vec3 around = ambientOn(normal) * look.openness;
  light = underFibres(light, fibres, around, sheen_, sheenRoughness_, abs(dotted(normal, view)));
#endif
  return light;
#endif
}
