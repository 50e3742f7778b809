// Fetches the vertices of instances by index (vertex pulling). One drawn instance contains `batch` copies of the shape,
// because drivers are slow with many instances of few triangles. An index value is copy << vertexBits | vertex.
#include "draw/instances/instance_list.glsl"
uniform int batch;
uniform int vertexBits;

// position outside the view for all vertices of unused copies in the last batch
const vec4 nowhere = vec4(0, 0, 2, 1);

// Reads the instance to which the current vertex belongs. Returns false for an unused copy.
bool pulled(out vec4 position, out vec4 velocity) {
  return listed(uint(gl_InstanceID * batch + (gl_VertexID >> vertexBits)), position, velocity);
}

int vertexOfShape() {
  return gl_VertexID & ((1 << vertexBits) - 1);
}

// Returns the corner (-1 or 1 in x and y) of InstanceShape::sprite for the current vertex.
vec2 squareCorner() {
  int vertex = vertexOfShape();
  return vec2((vertex & 1) != 0 ? 1 : -1, (vertex & 2) != 0 ? 1 : -1);
}
