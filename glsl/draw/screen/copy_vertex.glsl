#include "common/exact.glsl"
#include "draw/bindings.glsl"
layout(binding = shapeUnit) uniform samplerBuffer shape;  // two texels per vertex: position, normal
uniform bool alongVelocity;

// Returns the axes of a copy as columns: z along the velocity, x horizontal.
mat3 turned(vec3 velocity) {
  float speed = exactDot(velocity, velocity);
  if (!alongVelocity || !(speed > 1e-20)) return mat3(1);
  precise vec3 z = velocity * exactInverseSqrt(speed);
  vec3 level = exactCross(abs(z.y) < 0.9999 ? vec3(0, 1, 0) : vec3(0, 0, -1), z);
  precise vec3 x = level * exactInverseSqrt(exactDot(level, level));
  return mat3(x, exactCross(z, x), z);
}
