// Returns the fraction of a lamp's light that reaches a point, filtered in shader code over a few texels of its shadow
// maps (like draw/lights/lamp_shadow.glsl). `maps` of a lamp: x texels per side of a map, y texels per atlas row, z
// first row of the lamp's maps, w fraction of a map's side that spans 90 degrees.
#include "draw/lights/faces.glsl"
#include "draw/exact/shadows/shadow_filter.glsl"
#ifdef AREAS
#include "draw/exact/shadows/area_disc.glsl"
#endif
layout(binding = lampMapUnit) uniform usamplerBuffer lampKeys;

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
#ifdef AREAS
  vec4 up = lampUp(lamp);
  if (up.w > 0.0f) {
    // Computes a disc with the rectangle's area, in texels of a map at the distance 1 m, and the surface's plane on the
    // map.
    vec3 across = onFace(face, normal);
    float perTexel = exactReciprocal(sampling.y);
    precise float area = 0.318309886f * exactReciprocal(up.w);
    precise float spread = exactSqrt(area) * perTexel * exactReciprocal(sampling.x);
    // Limits the slope of the receiver's plane at grazing light.
    precise float least_ = -0.15f * exactSqrt(exactDot(q, q));
    precise float perOff = sampling.x * sampling.y * exactReciprocal(min(exactDot(across, q), least_));
    precise vec2 rise = across.yz * perOff;
    precise float maximum = 0.125f * maps.x - 2.0f;
    precise float minimum = 0.5f + sampling.z;
    return areaDiscFraction(lampKeys, map, AreaReceiver(middle, min(near, 1.0f), rise, spread, minimum, max(maximum, minimum)));
  }
#endif
#ifdef PIXEL_EXTENT
  vec3 step_ = onFace(face, pixelAlong);
  precise float closer = step_.x * perAlong;
  precise vec2 along = (step_.yz - q.yz * closer) * (0.5f * maps.w * maps.x * perAlong);
  // Taps beyond the border of the face would find casters of other places.
  precise vec2 beside = maps.x - middle;
  precise vec2 inside = min(middle, beside) - (sampling.z + 1.0f);
  precise float most = 2.0f * max(min(inside.x, inside.y), 0.0f);
  precise float change = -near * closer;
  precise vec3 extent = vec3(along, change) * spreadOver(along, sampling.z, most);
  Receiver receiver = Receiver(middle, min(near, 1.0f), extent);
#else
  Receiver receiver = Receiver(middle, min(near, 1.0f));
#endif
#if LAMP_TAPS == 4
  return litByFour(lampKeys, map, receiver, sampling.z);
#else
  return litBySixteen(lampKeys, map, receiver, sampling.z);
#endif
}
