// Returns the ball of an instance in view space, by index. A hidden instance has the radius 0.
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/instances/ball.glsl"
#include "draw/exact/instances/instance_source.glsl"

#include "draw/exact/depth.glsl"

BallHit hitOf(Ball ball, vec3 ray) {
#ifdef PARALLEL
  return ballHitAlong(ball, ray, view.forward.xyz);
#else
  return ballHit(ball, ray);
#endif
}
vec2 spanOf(Ball ball, vec3 along, int size) {
#ifdef PARALLEL
  return ballSpanAlong(ball, along, float(size));
#else
  return ballSpan(ball, along, view.forward.xyz, float(size));
#endif
}

Ball ballOf(vec4 position, vec4 velocity) {
  Ball ball = ballAt(position.xyz, 0.0f, view.eye.xyz, view.forward.xyz);
  float radius = radiusOf(position, velocity);
  ball.radius = radius > 0.0f ? max(radius, minRadius(position.xyz)) : 0.0f;
  return ball;
}
