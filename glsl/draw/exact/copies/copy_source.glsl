// Reads triangles of mesh copies, by index of the instance and of the triangle.
#include "common/once.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/instances/instance_source.glsl"
#include "draw/screen/copy_vertex.glsl"
layout(binding = indexUnit) uniform usamplerBuffer indices;
uniform uint triangles;  // number of triangles of one mesh copy
uint triangles_ = once(triangles);

struct Copy {
  vec3 place;
  mat3 axes;
  float scale;
};

Copy copyOf(int slot) {
  vec4 position = texelFetch(positions, slot), velocity = texelFetch(velocities, slot);
  return Copy(position.xyz, turned(slot, velocity.xyz), instanceSize(position.w));
}

ivec3 cornersOf(uint triangle) {
  int i = 3 * int(triangle);
  return ivec3(texelFetch(indices, i).x, texelFetch(indices, i + 1).x, texelFetch(indices, i + 2).x);
}

vec3 turnedBy(Copy copy, vec3 v) {
  precise vec3 q = copy.axes[0] * v.x + copy.axes[1] * v.y + copy.axes[2] * v.z;
  return q;
}

vec3 pointOf(Copy copy, int vertex) {
  precise vec3 v = copy.scale * texelFetch(shape, 2 * vertex).xyz;
  precise vec3 p = copy.place + turnedBy(copy, v);
  return p;
}

// Returns the vertex normal in world space. The normal does not have unit length.
vec3 normalOf(Copy copy, int vertex) {
  return turnedBy(copy, texelFetch(shape, 2 * vertex + 1).xyz);
}
