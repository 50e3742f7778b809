// Draws additive sprites: one square per instance that faces the eye.
#include "draw/frame_block.glsl"
#include "draw/instances/instance_pull.glsl"
#include "draw/surface/facing.glsl"
flat out vec3 tint;
out vec2 across;  // offset from the glow's centre, in units of its radius

void main() {
  vec4 position, velocity;
  gl_Position = nowhere;
  tint = vec3(0);
  across = vec2(0);
  if (!pulled(position, velocity)) return;
  Facing facing = facingEye(position.xyz);
  Glow glow = glowOf(position, velocity);
  tint = glow.light;
  across = squareCorner();
  vec3 outwards = across.x * facing.right + across.y * facing.up;
  gl_Position = frame.viewProjection * vec4(position.xyz + glow.radius * outwards, 1.0);
}
