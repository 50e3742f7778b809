#include "draw/frame_block.glsl"
#include "draw/surface/vertex_pull.glsl"
#include "draw/surface/light_map.glsl"

void main() {
  gl_Position = vec4(shadowPlace(worldPoint(gl_VertexID)) * 2.0 - 1.0, 1.0);
}
