// Returns the fraction of sunlight that reaches a point. SHADOW_TAPS: filtered over frame.shadowSoftness texels of the
// sun's shadow map. SUN_DISC: filtered over the penumbra of the sun's disc.
#ifndef EXACT_SUN_MAP
#define EXACT_SUN_MAP
#include "draw/exact/light_place.glsl"
#include "draw/exact/shadows/shadow_filter.glsl"
layout(binding = mapUnit) uniform usamplerBuffer sunMap;

#ifdef SUN_DISC
float casterNear(ivec2 texel) {
  int side = int(frame.shadowTexels);
  ivec2 at = clamp(texel, ivec2(0), ivec2(side - 1));
  uint key = texelFetch(sunMap, at.y * side + at.x).x;
  return key > nearKey(0.0f) ? -1e30f : intBitsToFloat(int(nearKey(0.0f) - key));
}
#include "draw/exact/shadows/disc_points.glsl"
#include "draw/exact/shadows/sun_disc.glsl"
#endif

// Returns the change of the nearness per texel along a surface. `least` limits the cosine between the normal and the
// sun's direction, because the surface's other side, or its neighbour in a fold, would be lit at grazing light.
vec2 riseOf(vec3 normal, float least) {
  float facing = exactDot(normal, frame.sunDirection.xyz);
  float along = facing < 0.0f ? min(facing, -least) : max(facing, least);
  precise vec2 across = vec2(exactDot(normal, frame.lightRight.xyz), exactDot(normal, frame.lightUp.xyz));
  precise float perTexel = lightTexel() * exactReciprocal(lightDepth());  // depth that equals the width of a texel
  precise vec2 rise = across * (-perTexel * exactReciprocal(along));
  return rise;
}

#ifdef SUN_DISC
// Returns the fraction at a position in the shadow map. `rise` is the change of the receiver's nearness per texel.
float sunFraction(vec3 place, vec2 rise) {
  precise float perTexel = lightTexel() * exactReciprocal(lightDepth());
  precise vec2 middle = place.xy * frame.shadowTexels;
  precise float near = 1.0f - place.z;
  precise float spread = frame.sunSpread * exactReciprocal(perTexel);
  precise float minimum = 0.5f + frame.shadowSoftness;
  return sunDiscFraction(SunReceiver(middle, near, rise, spread, minimum, frame.shadowReach));
}
#else
float sunFraction(vec3 place, vec2 rise) {
  int side = int(frame.shadowTexels);
  precise float near = 1.0f - place.z;
  precise vec2 middle = place.xy * frame.shadowTexels;
  ShadowMap map = ShadowMap(side, 0, side);
#ifdef PIXEL_EXTENT
  precise vec2 along = vec2(exactDot(lightAcross.xyz, pixelAlong), exactDot(lightUp.xyz, pixelAlong)) * frame.shadowTexels;
  precise vec2 extent = along * spreadOver(along, frame.shadowSoftness, 256.0f);
  Receiver receiver = Receiver(middle, near, rise, extent);
#else
  Receiver receiver = Receiver(middle, near, rise);
#endif
#if SHADOW_TAPS == 4
  return litByFour(sunMap, map, receiver, frame.shadowSoftness);
#else
  return litBySixteen(sunMap, map, receiver, frame.shadowSoftness);
#endif
}
#endif

// Returns the fraction for a receiver that is not in the map, so that it cannot shadow itself.
float sunFraction(vec3 place, vec3 normal) {
  return sunFraction(place, riseOf(normal, 0.02f));
}

// Offsets the lookup point to the lit side of the surface so that a curved surface does not shadow itself.
float sunFractionOn(vec3 p, vec3 normal) {
  precise float turned = 4.0f * exactDot(normal, frame.sunDirection.xyz);
  precise float lift = clamp(turned, -1.0f, 1.0f) * lightTexel() * (0.5f + 0.5f * frame.shadowSoftness);
  precise vec3 lifted = p + normal * lift;
  return sunFraction(lightPlace(lifted), riseOf(normal, 0.1f));
}
#endif
