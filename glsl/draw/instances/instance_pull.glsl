// Vertices of instances by number. Index values are copy << vertexBits | vertex: drivers are slow at many
// instances of few triangles, so one drawn instance holds `batch` copies of the shape.
#include "draw/instances/instance_list.glsl"
uniform int batch;
uniform int vertexBits;

// For copies that the last batch leaves unused: all vertices at one point out of sight.
const vec4 nowhere = vec4(0, 0, 2, 1);

// The instance that this vertex belongs to; false for an unused copy.
bool pulled(out vec4 position, out vec4 velocity) {
  return listed(uint(gl_InstanceID * batch + (gl_VertexID >> vertexBits)), position, velocity);
}

int vertexOfShape() {
  return gl_VertexID & ((1 << vertexBits) - 1);
}

// Of InstanceShape::sprite: -1 or 1.
vec2 squareCorner() {
  int vertex = vertexOfShape();
  return vec2((vertex & 1) != 0 ? 1 : -1, (vertex & 2) != 0 ? 1 : -1);
}
