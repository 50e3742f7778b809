// A ball of an instance, by number, as the eye sees it. Not shown ones have no radius.
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/instances/ball.glsl"
#include "draw/exact/instances/instance_source.glsl"

Ball ballOf(vec4 position, vec4 velocity) {
  Ball ball = ballAt(position.xyz, 0.0f, view.eye.xyz, view.forward.xyz);
  float radius = radiusOf(position, velocity);
  ball.radius = radius > 0.0f ? max(radius, minRadius(position.xyz)) : 0.0f;
  return ball;
}
