// Draws one triangle that covers the whole picture, with the camera ray at each corner.
#include "draw/frame_block.glsl"
#include "draw/passed_frame.glsl"
out vec3 ray;

void main() {
  passFrame();
  vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  // Row 0 of the target is the picture's top row.
  ray = frame.rayForward.xyz + frame.rayRight.xyz * at.x - frame.rayUp.xyz * at.y;
  gl_Position = vec4(at, 0.0, 1.0);
}
