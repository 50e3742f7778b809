// Returns the fraction of a lamp's light that reaches a point, filtered in shader code over a few texels of its shadow
// maps (like draw/lights/lamp_shadow.glsl). `maps` of a lamp: x texels per side of a map, y texels per atlas row, z
// first row of the lamp's maps, w fraction of a map's side that spans 90 degrees.
#include "draw/lights/faces.glsl"
#include "draw/exact/shadows/shadow_filter.glsl"
#ifdef AREAS
#include "draw/exact/shadows/area_disc.glsl"
#endif
layout(binding = lampMapUnit) uniform usamplerBuffer lampKeys;

// Normal of the plane of the surface that receives light, without bumps. Zero for the ground, which is not in the maps,
// and for balls, of which the maps show discs.
vec3 receivingPlane = vec3(0);

// Returns the change of the nearness per texel of a face's map along a plane. `q` and `normal` are a point of the plane
// and its normal in the face's coordinates. The cosine between the normal and the light is limited to `least`. `scale`:
// nearness at the distance 1 times the width of a texel there.
vec2 riseOnFace(vec3 normal, vec3 q, float least, float scale) {
  precise float grazing = least * exactSqrt(exactDot(q, q));
  float limit = max(grazing, 1e-9f), off = exactDot(normal, q);
  precise float per = scale * exactReciprocal(off > 0.0f ? max(off, limit) : min(off, -limit));
  precise vec2 rise = normal.yz * per;
  return rise;
}

// Returns the fraction of the lamp's light. `nl` is the cosine between the normal and the direction to the lamp. The
// lookup point is offset to the lit side of the surface so that the surface does not shadow itself.
float lampFraction(int lamp, vec3 from, vec3 normal, float nl) {
  vec4 maps = lampMaps(lamp), sampling = lampSampling(lamp);
  vec3 a = abs(from);
  precise float turned = 4.0f * nl;
#ifdef AREAS
  // Part of a rectangle may be above the horizon although its centre is below.
  turned = lampUp(lamp).w > 0.0f ? 1.0f : turned;
#endif
  precise float lift = clamp(turned, -1.0f, 1.0f) * (sampling.y * max(a.x, max(a.y, a.z))) * (0.5f + 0.5f * sampling.z);
  precise vec3 lifted = from + normal * lift;
  int face = faceOf(lifted);
  vec3 q = onFace(face, lifted);
  float perAlong = exactReciprocal(max(q.x, 1e-6f));
  precise vec2 middle = (0.5f + q.yz * (0.5f * maps.w * perAlong)) * maps.x;
  precise float near = sampling.x * perAlong;
  int side = int(maps.x), stride = int(maps.y), row = int(maps.z);
  int first = row * stride;
  first += face * side;
  ShadowMap map = ShadowMap(side, first, stride);
  bool mapped = receivingPlane != vec3(0);
  vec3 plane = onFace(face, mapped ? receivingPlane : normal);
  precise float perTexelNear = sampling.x * sampling.y;
#ifdef AREAS
  vec4 up = lampUp(lamp);
  if (up.w > 0.0f) {
    // Computes a disc with the rectangle's area, in texels of a map at the distance 1 m, and the surface's plane on the
    // map.
    float perTexel = exactReciprocal(sampling.y);
    precise float area = 0.318309886f * exactReciprocal(up.w);
    precise float spread = exactSqrt(area) * perTexel * exactReciprocal(sampling.x);
    vec2 rise = riseOnFace(plane, q, 0.15f, perTexelNear);
    precise float maximum = 0.125f * maps.x - 2.0f;
    precise float minimum = 0.5f + sampling.z;
    return areaDiscFraction(lampKeys, map, AreaReceiver(middle, min(near, 1.0f), rise, spread, minimum, max(maximum, minimum)));
  }
#endif
#ifdef PIXEL_EXTENT
  vec2 rise = riseOnFace(plane, q, 0.02f, perTexelNear);
  vec3 step_ = onFace(face, pixelAlong);
  precise float closer = step_.x * perAlong;
  precise vec2 along = (step_.yz - q.yz * closer) * (0.5f * maps.w * maps.x * perAlong);
  // Taps beyond the border of the face would find casters of other places.
  precise vec2 beside = maps.x - middle;
  precise vec2 inside = min(middle, beside) - (sampling.z + 1.0f);
  precise float most = 2.0f * max(min(inside.x, inside.y), 0.0f);
  precise vec2 extent = along * spreadOver(along, sampling.z, most);
  Receiver receiver = Receiver(middle, min(near, 1.0f), rise, extent);
#else
  vec2 rise = mapped ? riseOnFace(plane, q, 0.1f, perTexelNear) : vec2(0);
  Receiver receiver = Receiver(middle, min(near, 1.0f), rise);
#endif
#if LAMP_TAPS == 4
  return litByFour(lampKeys, map, receiver, sampling.z);
#else
  return litBySixteen(lampKeys, map, receiver, sampling.z);
#endif
}
