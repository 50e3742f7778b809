// Light through a layer of clear surfaces (GLASS), as the change of the light of the picture behind it. Light passes two
// surfaces of a solid, or one thin sheet. Through the back of a solid, which belongs to the layer in front of it, nothing
// is added. REFRACTED: the ray through a solid is refracted and followed through the picture, to the ground and the sky;
// otherwise the layer shows the picture straight behind it.
#include "draw/exact/surface/refraction.glsl"
layout(binding = behindUnit) uniform sampler2D behindLight;
layout(binding = layerNearUnit) uniform usamplerBuffer layerKeys;
#ifndef PAIRED
layout(binding = layerIdUnit) uniform usamplerBuffer layerIds;
#endif
uniform vec2 glass;  // x: transmission, y: index of refraction
vec2 glass_ = once(glass);
uniform vec3 absorbed;  // light that the solid absorbs (1/m)
vec3 absorbed_ = once(absorbed);
uniform ivec4 glassLayer;  // 1 if: x: the surface is a thin sheet; y: the layer is the nearest; z: layerKeys has the layer
                           // behind it; w: the picture has no sky (transparent)
ivec4 glassLayer_ = once(glassLayer);

struct Exit {
  vec3 place;
  vec3 normal;  // outward unit normal
  bool found;
};

// Returns where the straight ray leaves the solid: on the next layer, if that shows a back side of the same surface.
Exit exitBehind(Spot spot, ivec2 pixel, int sampleAt) {
  Exit exit = Exit(spot.place, -spot.normal, false);
  int at = firstSample(pixel) + sampleAt;
#ifdef PAIRED
  uint id = glassLayer_.z != 0 ? texelFetch(layerKeys, at).x : emptyId;
#else
  uint id = glassLayer_.z != 0 ? texelFetch(layerIds, at).x : emptyId;
#endif
  if (id >= firstId_ && id - firstId_ < uint(trianglesToDraw())) {
    Spot last = spotOf(cornersOf(int(id - firstId_)), pixel, sampleAt);
    if (last.turned) exit = Exit(last.place, last.normal, true);
  }
  return exit;
}

#ifdef REFRACTED
// Returns the curvature of the surface (1/m): the larger of those along x and y of the picture, or 0 if it is hollow.
float curvatureOn(Spot spot) {
  vec3 a = unpackedUnit(texelFetch(vertices, spot.corners.x).w), b = unpackedUnit(texelFetch(vertices, spot.corners.y).w);
  vec3 c = unpackedUnit(texelFetch(vertices, spot.corners.z).w);
  float maximum = 0.0f;
  for (int i = 0; i < 2; ++i) {
    vec2 aside = vec2(i == 0 ? 2.0f : 0.0f, i == 0 ? 0.0f : 2.0f);
    vec3 w = weightsBeside(spot, aside);
    precise vec2 there = spot.at + aside;
    precise vec3 moved = placeUnder(w, spot.a.z, spot.b.z, spot.c.z, rayThrough(there)) - spot.place;
    precise vec3 mean = w.x * a + w.y * b + w.z * c;
    precise vec3 turned = unitOf(mean) - spot.normal;
    precise float curvature = exactDot(turned, moved) * exactReciprocal(max(exactDot(moved, moved), 1e-20f));
    maximum = max(maximum, curvature);
  }
  return maximum;
}

// Returns the light that a refracted ray meets: objects of the picture, else the ground, else the sky.
vec3 lightBeyond(Crossing crossing, vec3 towards, float roughness) {
#ifdef GROUND_BELOW
  float ground = groundAlong(crossing.place, crossing.direction);
#else
  const float ground = -1.0f;
#endif
  vec4 met = lightMet(crossing.place, crossing.direction, ground, towards, roughness);
  precise vec3 around = skyMirrored(crossing.direction, roughness);
#ifdef GROUND_BELOW
  GroundMirrored below = groundMirrored(crossing.place, crossing.direction, min(roughness, mirrorSmooth), 1.0f);
  IF_ANY(below.counts > 0.0f) {
    vec3 lit = groundInSun(below, crossing.direction);
#ifdef LAMPS
    precise vec3 sum = lit + lampsOnMirrored(below, crossing.direction);
    lit = sum;
#endif
    around = around + below.counts * (lit - around);
  }
#endif
  precise vec3 light = met.rgb + (1.0f - met.w) * around;
  return light;
}
#endif

// Returns the change of the light and coverage behind the layer. `light`: what the surface itself sends to the eye.
vec4 throughGlass(vec3 light, vec3 base, float roughness, Spot spot, ivec2 pixel, int sampleAt) {
  bool thin = glassLayer_.x != 0;
  if (spot.turned && !thin && glassLayer_.y == 0) return vec4(0);
  vec4 behind = texelFetch(behindLight, pixel, 0);
  vec3 n = spot.turned ? -spot.normal : spot.normal;
  Exit exit = exitBehind(spot, pixel, sampleAt);
  bool solid = exit.found && !thin && !spot.turned;
  precise vec3 straight = exit.place - spot.place;
  float metres = solid ? exactSqrt(exactDot(straight, straight)) : 0.0f;
  precise vec3 seen = behind.rgb;
  precise float open = 1.0f - behind.a;
  if (glassLayer_.w == 0) seen = seen + open * skyInDirection(-spot.view);
#ifdef REFRACTED
  if (solid) {
    Crossing crossing = crossingOf(spot.place, spot.view, n, curvatureOn(spot), exit.place, exit.normal, glass_.y);
    turns_ = turnsOn(spot);
    metres = crossing.metres;
    seen = lightBeyond(crossing, spot.view, roughness);
    open = 0.0f;
  }
#endif
  float kept = barycentricWeights(vec3(1), roughness, 0.0f, exactDot(n, spot.view)).matt.x;
  precise vec3 part = glass_.x * kept * kept * base * leftAfter(absorbed_, metres);
#ifdef HAZE
  // The picture straight behind the layer already shows the haze before the layer.
  float passes = passed(hazeBefore(spot.place));
#ifdef REFRACTED
  vec3 already = solid ? vec3(0.0f) : part;
  precise vec3 own = light * passes + hazeTowards(-spot.view) * ((1.0f - already) * (1.0f - passes));
  precise vec3 ray = part * (solid ? passes : 1.0f);
  part = ray;
#else
  precise vec3 own = light * passes + hazeTowards(-spot.view) * ((1.0f - part) * (1.0f - passes));
#endif
  light = own;
#endif
  precise vec3 change = light + part * seen - behind.rgb;
  precise float cover = glassLayer_.w == 0 ? 1.0f - behind.a : 1.0f - exactDot(part, vec3(0.333333f)) * open - behind.a;
  return vec4(change, cover);
}
