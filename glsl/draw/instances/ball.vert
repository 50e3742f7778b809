// Draws opaque sprites: one square per instance that faces the eye. ball.frag draws a ball on the square.
#include "draw/frame_block.glsl"
#include "draw/instances/instance_pull.glsl"
#include "draw/surface/light_map.glsl"
#include "draw/surface/facing.glsl"
flat out vec3 tint;
flat out vec3 middle;
flat out vec2 radii;  // x: radius of the ball; y: radius of its outline on the square (m)
out vec3 worldPosition;
out vec3 place;
out vec3 placeRay;  // vector from the eye to the point, in shadow map coordinates

void main() {
  vec4 position, velocity;
  gl_Position = nowhere;
  tint = middle = worldPosition = place = placeRay = vec3(0);
  radii = vec2(0);
  if (!pulled(position, velocity)) return;
  Facing facing = facingEye(position.xyz);
  float radius = max(instanceSize(position.w) * shapeRadius, minRadius(position.xyz));
  float outline = outlineRadius(radius, facing.distance);
  vec2 corner = squareCorner();
  vec3 outwards = corner.x * facing.right + corner.y * facing.up;
  vec3 lift = shadowLift(frame.sunDirection.xyz);
  tint = tintOf(position, velocity);
  middle = position.xyz;
  radii = vec2(radius, outline);
  worldPosition = position.xyz + outline * outwards;
  place = shadowPlace(worldPosition + lift);
  placeRay = place - shadowPlace(frame.eye.xyz + (1.0 - frame.eye.w) * worldPosition + lift);
  gl_Position = frame.viewProjection * vec4(worldPosition, 1.0);
}
