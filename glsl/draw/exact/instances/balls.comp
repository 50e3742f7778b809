// Small balls of instances, an invocation each; the numbers of the others go on a list (large_balls.comp): large ones from its
// beginning, with MEDIUM those of medium size from its end on. SAMPLES, PASS.
#define EXACT_PICTURE
#include "draw/exact/instances/raster_ball.glsl"
#include "draw/exact/instances/box.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = largeBinding) restrict buffer LargeBlock { uint large[]; };
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint counters[]; };
#include "draw/exact/list_place.glsl"
uniform int draw_;        // number of the instances among those drawn
uniform int firstLarge;   // where their list begins
uniform int smallPixels;  // the longest side of a small one's box
#ifdef MEDIUM
uniform int mediumPixels;  // of one of medium size
uniform int draws;
#endif

void main() {
  int number = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (number >= capacity) return;
  Ball ball = ballOf(texelFetch(positions, number), texelFetch(velocities, number));
  ivec4 box = pixelsOfBall(ball);
  if (box.z < box.x || box.w < box.y) return;
  if (max(box.z - box.x, box.w - box.y) >= smallPixels) {
#if PASS == 0
#ifdef MEDIUM
    if (max(box.z - box.x, box.w - box.y) < mediumPixels)
      large[firstLarge + capacity - 1 - int(nextPlace(draws + draw_))] = uint(number);
    else
#endif
    large[firstLarge + int(nextPlace(draw_))] = uint(number);
#endif
    return;
  }
  Rays rays = raysOfView();
  ivec2 pixel = box.xy;
  int pixels = pixelsIn(box);
  for (int i = 0; i < pixels; ++i) {
    putBall(ball, rays, pixel, firstId + uint(number));
    pixel = nextIn(box, pixel);
  }
}
