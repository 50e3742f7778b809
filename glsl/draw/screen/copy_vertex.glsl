#include "common/exact.glsl"
#include "draw/bindings.glsl"
layout(binding = shapeUnit) uniform samplerBuffer shape;  // two texels per vertex: position and normal
layout(binding = turnUnit) uniform samplerBuffer turns;   // one texel per copy: direction, or quaternion (x, y, z, w)
uniform int turning;  // rotation of copies, a value of sim::Instances::Turning

// Returns the axes of a copy as columns: z along the direction, x horizontal.
mat3 axesAlong(vec3 direction) {
  float length2 = exactDot(direction, direction);
  if (!(length2 > 1e-20) || !isNumber(length2)) return mat3(1);
  precise vec3 z = direction * exactInverseSqrt(length2);
  vec3 level = exactCross(abs(z.y) < 0.9999 ? vec3(0, 1, 0) : vec3(0, 0, -1), z);
  precise vec3 x = level * exactInverseSqrt(exactDot(level, level));
  return mat3(x, exactCross(z, x), z);
}

// Returns v rotated by a unit quaternion.
vec3 turnedBy(vec4 q, vec3 v) {
  precise vec3 inner = exactCross(q.xyz, v) + q.w * v;
  precise vec3 result = v + 2.0 * exactCross(q.xyz, inner);
  return result;
}

// Returns the axes of copy number `slot` as columns.
mat3 turned(int slot, vec3 velocity) {
  if (turning == 0) return mat3(1);
  if (turning == 1) return axesAlong(velocity);
  vec4 turn = texelFetch(turns, slot);
  if (turning == 2) return axesAlong(turn.xyz);
  float length2 = exactDot(turn, turn);
  if (!(length2 > 1e-20) || !isNumber(length2)) return mat3(1);
  precise vec4 q = turn * exactInverseSqrt(length2);
  return mat3(turnedBy(q, vec3(1, 0, 0)), turnedBy(q, vec3(0, 1, 0)), turnedBy(q, vec3(0, 0, 1)));
}
