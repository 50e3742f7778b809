// Rasterizes the large balls in the list of balls.comp. For each ball, the workgroups split the tiles between them.
// MEDIUM: first rasterizes the medium-sized balls, one per workgroup. SAMPLES, PASS: as in
// draw/exact/visible_sample.glsl.
#define EXACT_PICTURE
#include "draw/exact/instances/raster_ball.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
uniform int draw_;
uniform int firstLarge;

void drawLarge(int number) {
  Ball ball = ballOf(texelFetch(positions, number), texelFetch(velocities, number));
  ivec4 box = pixelsOfBall(ball);
  Rays rays = raysOfView();
  int across = (box.z - box.x) / tileSide + 1;
  int tiles = across * ((box.w - box.y) / tileSide + 1);
  for (int tile = int(gl_WorkGroupID.z); tile < tiles; tile += int(gl_NumWorkGroups.z)) {
    ivec2 pixel = box.xy + ivec2(tile % across, tile / across) * tileSide + ivec2(gl_LocalInvocationID.xy);
    if (pixel.x <= box.z && pixel.y <= box.w) putBall(ball, rays, pixel, firstId + uint(number));
  }
}

#ifdef MEDIUM
#include "draw/exact/instances/box.glsl"
uniform int draws;

void drawMedium(int number) {
  Ball ball = ballOf(texelFetch(positions, number), texelFetch(velocities, number));
  ivec4 box = pixelsOfBall(ball);
  Rays rays = raysOfView();
  int across = box.z - box.x + 1, pixels = pixelsIn(box);
  for (int i = int(gl_LocalInvocationIndex); i < pixels; i += 64)
    putBall(ball, rays, box.xy + ivec2(i % across, i / across), firstId + uint(number));
}

void drawMediums() {
  uint count = texelFetch(counters, draws + draw_).x, groups = gl_NumWorkGroups.x * gl_NumWorkGroups.z;
  for (uint entry = gl_WorkGroupID.z * gl_NumWorkGroups.x + gl_WorkGroupID.x; entry < count; entry += groups)
    drawMedium(int(texelFetch(large, firstLarge + capacity - 1 - int(entry)).x));
}
#endif

void main() {
#ifdef MEDIUM
  drawMediums();
#endif
  uint count = texelFetch(counters, draw_).x, groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y;
  for (uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; entry < count; entry += groups)
    drawLarge(int(texelFetch(large, firstLarge + int(entry)).x));
}
