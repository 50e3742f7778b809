// Light that a metal/rough surface under sun, sky and lamps reflects to the eye. Compiles as GLSL and as C++. Defines:
// TRANSLUCENT, REFLECTIVE, LAMPS.
// SHEEN: the surface has fabric fibres with the colour sheen_ and the roughness sheenRoughness_.
// JOINED: one kernel shades several surfaces, only some of which are REFLECTIVE; `mirrors` is true for these.
// SHOWN: outputs the normal (1) or the base colour (2) instead of light.
// REFLECTED: outputs the change of the light if reflected rays hit objects of the picture, and with GROUND_BELOW the
// ground, instead of the surroundings (draw/exact/reflections).
#include "draw/sky.glsl"
#include "draw/surface/shading.glsl"
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

#ifdef REFLECTIVE
FUNCTION vec3 mattPart(Look look) {
  ROUNDED vec3 part = look.base * (1.0f - look.metallic);
  return part;
}
FUNCTION vec3 mirrorPart(Look look) {
  return blend(vec3(0.04f), look.base, look.metallic);
}
#else
FUNCTION vec3 mattPart(Look look) {
  return look.base;
}
FUNCTION vec3 mirrorPart(Look look) {
  return vec3(0.04f);
}
#endif

// Returns the light of sun and sky. `fraction`: fraction of sunlight that reaches the point; `normal` points to the
// viewer's side. GROUND_BELOW: reflections also show the ground.
FUNCTION vec3 surfaceLight(Look look, vec3 p, vec3 normal, vec3 view, float fraction) {
  vec3 sun = vec3(frame.sunDirection), sunLight = vec3(frame.sunLight);
  float nl = dotted(normal, sun);
  ROUNDED float lit = max(nl, 0.0f) * fraction;
  vec3 matt = mattPart(look);
  vec3 mirror = mirrorPart(look);
  ROUNDED vec2 lobed = sunLobe(normal, view, sun, look.roughness) * lit;
#ifdef TRANSLUCENT
  ROUNDED float behind = max(-nl, 0.0f) * fraction;
  ROUNDED float direct = lit + (behind - lit) * look.translucency;
  vec3 ambient = blend(ambientOn(normal), ambientOn(-normal), look.translucency);
#else
  float direct = lit;
  vec3 ambient = ambientOn(normal);
#endif
  ROUNDED vec3 light = matt * (sunLight * direct + look.openness * ambient) + (mirror * lobed.x + lobed.y) * sunLight;
#ifdef REFLECTIVE
#ifdef JOINED
  if (!mirrors) return light;
#endif
  float nv = dotted(normal, view);
  ROUNDED vec3 direction = 2.0f * nv * normal - view;
  vec2 weight = ambientLobe(look.roughness, abs(nv));
  vec3 around = skyMirrored(direction, look.roughness);
  light = light + look.openness * (mirror * weight.x + weight.y) * around;
#ifdef GROUND_BELOW
  GroundMirrored below = groundMirrored(p, direction, look.roughness, look.openness);
  // Uses a loop of at most one iteration instead of a branch, because software drivers execute both sides of a branch.
  for (int i = below.counts > 0.0f ? 0 : 1; i < 1; ++i)
    light = light + below.counts * (mirror * weight.x + weight.y) * (groundInSun(below, direction) - look.openness * around);
#endif
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
  for (int i = smooth_ ? 0 : 1; i < 1; ++i) met = lightMet(p, direction, ground, view, look.roughness);
#ifdef GROUND_BELOW
  GroundMirrored below = groundMirrored(p, direction, look.roughness, look.openness);
#endif
#if defined GROUND_BELOW && defined LAMPS
  bool changes = met.w > 0.0f || below.counts > 0.0f;
#else
  bool changes = met.w > 0.0f;
#endif
  for (int i = changes ? 0 : 1; i < 1; ++i) {
    vec2 weight = ambientLobe(look.roughness, abs(nv));
    ROUNDED vec3 around = look.openness * skyMirrored(direction, look.roughness), more = vec3(0.0f);
#ifdef GROUND_BELOW
#ifdef LAMPS
    more = below.counts * lampsOnGround(below.p, -direction);
#endif
    around = around + below.counts * (groundInSun(below, direction) - around) + more;
#endif
    ROUNDED vec3 change = (mirrorPart(look) * weight.x + weight.y) * (more + vec3(met) - met.w * around);
    light = change;
  }
#endif
  return light;
}
#endif

// Returns the light of sun, sky and lamps. p: position at which the lamps' light is computed.
FUNCTION vec3 allLight(Look look, vec3 p, vec3 normal, vec3 view, float fraction) {
#ifdef SHOWN
  return SHOWN == 1 ? normal : look.base;
#endif
#ifdef REFLECTED
  vec3 light = reflectedChange(look, p, normal, view);
#ifdef SHEEN
  light = underFibres(light, vec3(0), vec3(0), sheen_, sheenRoughness_, abs(dotted(normal, view)));
#endif
  return light;
#else
  vec3 light = surfaceLight(look, p, normal, view, fraction);
#ifdef LAMPS
  LampLight lamps = lampLight(p, normal, view, mirrorPart(look), look.roughness, look.translucency);
  ROUNDED vec3 sum = light + mattPart(look) * lamps.matt + lamps.mirror;
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
