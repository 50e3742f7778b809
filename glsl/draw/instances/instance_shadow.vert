// Draws instances into the sun's shadow map. SPRITE: draws a square that faces the sun.
#include "draw/frame_block.glsl"
#include "draw/instances/instance_pull.glsl"
#include "draw/screen/copy_vertex.glsl"
#include "draw/surface/light_map.glsl"
#ifdef SPRITE
out vec2 across;
#endif

void main() {
  vec4 position, velocity;
  gl_Position = nowhere;
#ifdef SPRITE
  across = squareCorner();
#endif
  if (!pulled(position, velocity)) return;
  float scale = instanceSize(position.w);
#ifdef SPRITE
  vec2 corner = squareCorner() * (scale * shapeRadius);
  vec3 world = position.xyz + corner.x * frame.lightRight.xyz + corner.y * frame.lightUp.xyz;
#else
  vec3 world = position.xyz + turned(listedSlot, velocity.xyz) * (scale * texelFetch(shape, vertexOfShape() * 2).xyz);
#endif
  gl_Position = vec4(shadowPlace(world) * 2.0 - 1.0, 1.0);
}
