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
flat out vec3 towards;     // the eye
flat out vec3 bulge;       // from the middle to the ball's nearest point, and
flat out vec3 placeBulge;  //     the same in the light's map
out vec3 across;           // from the middle, in radii
out vec3 worldPosition;
out vec3 place;
#endif

void main() {
  vec4 position, velocity;
  gl_Position = nowhere;
#ifdef SMALL
  shade = vec3(0);
#else
  tint = towards = bulge = placeBulge = across = worldPosition = place = vec3(0);
#endif
  if (!pulled(position, velocity)) return;
  Facing facing = facingEye(position.xyz);
  float radius = outlineRadius(instanceSize(position.w) * shapeRadius, facing.distance);
  radius = max(radius, leastRadius(position.xyz));
  vec2 corner = squareCorner();
  vec3 outwards = corner.x * facing.right + corner.y * facing.up;
  vec3 lift = shadowLift(frame.sunDirection.xyz);
#ifdef SMALL
  const float halfSide = 0.8862269;  // sqrt(pi) / 2
  gl_Position = frame.viewProjection * vec4(position.xyz + radius * halfSide * outwards, 1.0);
  // Half way between middle and outline the ball has its mean shade.
  vec3 normal = 0.5 * outwards + 0.7071068 * facing.towards;
  float share = sunShare(shadowPlace(position.xyz + radius * normal + lift));
  shade = surfaceLight(tintOf(position, velocity), normal, facing.towards, share);
#else
  tint = tintOf(position, velocity);
  towards = facing.towards;
  across = outwards;
  bulge = radius * towards;
  worldPosition = position.xyz + radius * across;
  place = shadowPlace(worldPosition + lift);
  placeBulge = shadowPlace(worldPosition + lift + bulge) - place;
  gl_Position = frame.viewProjection * vec4(worldPosition, 1.0);
#endif
}
