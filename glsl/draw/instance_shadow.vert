// Instances into the light's map. SPRITE: a square facing the sun. SMALL: of the ball's area, without a disk.
#include "draw/frame_block.glsl"
#include "draw/instance_pull.glsl"
#include "draw/copy_vertex.glsl"
#include "draw/light_map.glsl"
#if defined(SPRITE) && !defined(SMALL)
out vec2 across;
#endif

void main() {
  vec4 position, velocity;
  gl_Position = nowhere;
#if defined(SPRITE) && !defined(SMALL)
  across = squareCorner();
#endif
  if (!pulled(position, velocity)) return;
  float scale = instanceSize(position.w);
#ifdef SPRITE
  vec2 corner = squareCorner() * (scale * shapeRadius);
#ifdef SMALL
  corner *= 0.8862269;  // sqrt(pi) / 2
#endif
  vec3 world = position.xyz + corner.x * frame.lightRight.xyz + corner.y * frame.lightUp.xyz;
#else
  vec3 world = position.xyz + turned(velocity.xyz) * (scale * texelFetch(shape, vertexOfShape() * 2).xyz);
#endif
  gl_Position = vec4(shadowPlace(world) * 2.0 - 1.0, 1.0);
}
