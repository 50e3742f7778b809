// Computes the vertices of a terrain from the heights of a user's grid. One invocation per vertex.
#include "common/memory.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, HeightBlock, heights)  // x: height value
STATE_ARRAY(1, VertexBlock, vertices)
uniform ivec2 size;   // number of vertices along x and z
uniform vec3 corner;  // position of vertex (0, 0) for the height value 0, m
uniform float cell;   // distance between vertices, m
uniform float scale;  // height in metres per unit of the height value

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= size.x * size.y) return;
  precise float x = corner.x + float(i % size.x) * cell;
  precise float y = corner.y + LOAD_INPUT(heights, i).x * scale;
  precise float z = corner.z + float(i / size.x) * cell;
  STORE_STATE(vertices, i, vec4(x, y, z, 1.0));
}
