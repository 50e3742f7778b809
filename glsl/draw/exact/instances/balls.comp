// Rasterizes the small balls of instances, one per invocation. Appends the other balls to a list (large_balls.comp):
// large balls from its start and, with MEDIUM, medium-sized balls from its end. SAMPLES, PASS: as in
// draw/exact/visible_sample.glsl.
#define EXACT_PICTURE
#include "draw/exact/instances/raster_ball.glsl"
#include "draw/exact/instances/box.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = largeBinding) restrict buffer LargeBlock { uint large[]; };
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint counters[]; };
#include "draw/exact/list_place.glsl"
uniform int draw_;        // index of the current instances among all drawn instances
uniform int firstLarge;   // first entry of the current instances in the list of larger balls
uniform int smallPixels;  // max side (pixels) of a small ball's bounding box
#ifdef MEDIUM
uniform int mediumPixels;  // max side (pixels) of a medium-sized ball's bounding box
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
