// Opaque sprites: a square facing the eye for each, on which ball.frag draws a ball. SMALL: a ball of few pixels
// is a square of its outline's area, lit at its corners.
#include "draw/frame_block.glsl"
#include "draw/instance_pull.glsl"
#include "draw/light_map.glsl"
#include "draw/facing.glsl"
#ifdef SMALL
#include "draw/lighting.glsl"
out vec3 shade;
#else
flat out vec3 tint;
flat out vec3 middle;
flat out vec2 radii;  // of the ball, and of its outline on the square (m)
out vec3 worldPosition;
out vec3 place;
out vec3 placeRay;  // from the eye to the place
#endif

void main() {
  vec4 position, velocity;
  gl_Position = nowhere;
#ifdef SMALL
  shade = vec3(0);
#else
  tint = middle = worldPosition = place = placeRay = vec3(0);
  radii = vec2(0);
#endif
  if (!pulled(position, velocity)) return;
  Facing facing = facingEye(position.xyz);
  float radius = max(instanceSize(position.w) * shapeRadius, leastRadius(position.xyz));
  float outline = outlineRadius(radius, facing.distance);
  vec2 corner = squareCorner();
  vec3 outwards = corner.x * facing.right + corner.y * facing.up;
  vec3 lift = shadowLift(frame.sunDirection.xyz);
#ifdef SMALL
  const float halfSide = 0.8862269;  // sqrt(pi) / 2
  gl_Position = frame.viewProjection * vec4(position.xyz + outline * halfSide * outwards, 1.0);
  // The part of the ball that is seen faces the eye by 2/3 in the mean.
  vec3 normal = 0.5270463 * outwards + 0.6666667 * facing.towards;
  float share = sunShare(shadowPlace(position.xyz + radius * normal + lift));
  shade = surfaceLight(tintOf(position, velocity), normal, facing.towards, share);
#else
  tint = tintOf(position, velocity);
  middle = position.xyz;
  radii = vec2(radius, outline);
  worldPosition = position.xyz + outline * outwards;
  place = shadowPlace(worldPosition + lift);
  placeRay = place - shadowPlace(frame.eye.xyz + lift);
  gl_Position = frame.viewProjection * vec4(worldPosition, 1.0);
#endif
}
