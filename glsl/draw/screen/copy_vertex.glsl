#include "draw/bindings.glsl"
layout(binding = shapeUnit) uniform samplerBuffer shape;  // position and normal of each vertex
uniform bool alongVelocity;

// Columns are the copy's axes: its z axis lies along the velocity, its x axis level.
mat3 turned(vec3 velocity) {
  float speed = dot(velocity, velocity);
  if (!alongVelocity || !(speed > 1e-20)) return mat3(1);
  vec3 z = velocity * inversesqrt(speed);
  vec3 x = normalize(cross(abs(z.y) < 0.9999 ? vec3(0, 1, 0) : vec3(0, 0, -1), z));
  return mat3(x, cross(z, x), z);
}
