// Draws instances into one shadow map of a lamp. SPRITE: draws a square that faces the lamp; the outline of the ball is
// a disc on that square.
#include "draw/frame_block.glsl"
#include "draw/instances/instance_pull.glsl"
#include "draw/screen/copy_vertex.glsl"
#include "draw/lights/face_clip.glsl"
#include "draw/surface/facing.glsl"
uniform int cell;
#ifdef SPRITE
out vec2 across;
#endif

void main() {
  vec4 position, velocity;
  gl_Position = nowhereOnFaces();
#ifdef SPRITE
  across = squareCorner();
#endif
  if (!pulled(position, velocity)) return;
  float scale = instanceSize(position.w);
#ifdef SPRITE
  vec3 to = lampPlace(cell / lampFaces).xyz - position.xyz;
  float distance = max(length(to), 1e-6), radius = scale * shapeRadius;
  vec3 helper = abs(to.y) > 0.9 * distance ? vec3(0, 0, 1) : vec3(0, 1, 0);
  vec3 right = normalize(cross(helper, to));
  vec2 corner = squareCorner() * outlineRadius(radius, distance);
  vec3 world = position.xyz + corner.x * right + corner.y * cross(to / distance, right);
#else
  vec3 world = position.xyz + turned(listedSlot, velocity.xyz) * (scale * texelFetch(shape, vertexOfShape() * 2).xyz);
#endif
  gl_Position = clipOnFace(cell, world);
}
