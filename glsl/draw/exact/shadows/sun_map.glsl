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

// Returns the fraction at a position in the shadow map. `normal` is the normal of the receiving surface; a flat surface
// casts no shadow on itself. `nearer` is the nearness by which the receiver is moved towards the light.
float sunFraction(vec3 place, vec3 normal, float nearer) {
  float perDepth = exactReciprocal(lightDepth());
  precise float perTexel = lightTexel() * perDepth;  // difference of depth that equals the width of a texel
  float along = max(exactDot(normal, frame.sunDirection.xyz), 0.1f);
  precise vec2 across = vec2(exactDot(normal, frame.lightRight.xyz), exactDot(normal, frame.lightUp.xyz));
  precise vec2 rise = across * (-perTexel * exactReciprocal(along));
  precise vec2 middle = place.xy * frame.shadowTexels;
  precise float near = 1.0f - place.z + nearer;
  precise float spread = frame.sunSpread * exactReciprocal(perTexel);
  precise float minimum = 0.5f + frame.shadowSoftness;
  return sunDiscFraction(SunReceiver(middle, near, rise, spread, minimum, frame.shadowReach));
}
#else
float sunFraction(vec3 place, vec3 normal, float nearer) {
  int side = int(frame.shadowTexels);
  precise float near = 1.0f - place.z + nearer;
  precise vec2 middle = place.xy * frame.shadowTexels;
  ShadowMap map = ShadowMap(side, 0, side);
#ifdef PIXEL_EXTENT
  precise vec2 along = vec2(exactDot(lightAcross.xyz, pixelAlong), exactDot(lightUp.xyz, pixelAlong)) * frame.shadowTexels;
  precise vec3 extent = vec3(along, -exactDot(lightAway.xyz, pixelAlong)) * spreadOver(along, frame.shadowSoftness, 256.0f);
  Receiver receiver = Receiver(middle, near, extent);
#else
  Receiver receiver = Receiver(middle, near);
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
  return sunFraction(place, normal, 0.0f);
}

// Returns the nearness by which the depth of a surface in the map may differ within the filter: its slope, limited to 3,
// times 1.5 + frame.shadowSoftness texels. The receiver has this offset, not the casters, whose shadows on other surfaces
// would begin away from them.
float slopeNear(vec3 normal) {
  float along = max(abs(exactDot(normal, frame.sunDirection.xyz)), 0.33f);
  float across = max(abs(exactDot(normal, frame.lightRight.xyz)), abs(exactDot(normal, frame.lightUp.xyz)));
  precise float perTexel = lightTexel() * exactReciprocal(lightDepth());
  precise float near = (1.5f + frame.shadowSoftness) * perTexel * across * exactReciprocal(along);
  return near;
}

// Offsets the lookup point to the lit side of the surface so that the surface does not shadow itself.
float sunFractionOn(vec3 p, vec3 normal) {
  precise float turned = 4.0f * exactDot(normal, frame.sunDirection.xyz);
  precise float lift = clamp(turned, -1.0f, 1.0f) * lightTexel() * (0.5f + 0.5f * frame.shadowSoftness);
  precise vec3 lifted = p + normal * lift;
  return sunFraction(lightPlace(lifted), normal, slopeNear(normal));
}
#endif
