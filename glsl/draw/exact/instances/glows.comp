// Adds the light of small glows to the sums, one glow per invocation. Appends the other glows to a list: large glows
// from its start and, with MEDIUM, medium-sized glows from its end. LARGE: handles the listed glows. With MEDIUM, it
// first handles the medium-sized ones, one per workgroup. Then it handles the large ones; for each glow, the workgroups
// split the tiles between them. BALL: glows are spheres (glow_disc.glsl). SAMPLES: samples per pixel.
#define EXACT_PICTURE
#include "draw/exact/instances/glow_disc.glsl"
uniform int draw_;        // index of the current instances among all additive instances
uniform int firstLarge;   // first entry of the current instances in the list of larger glows
uniform int smallPixels;  // max side (pixels) of a small glow's bounding box
#ifdef MEDIUM
uniform int mediumPixels;  // max side (pixels) of a medium-sized glow's bounding box
uniform int draws;
#endif
#ifdef LARGE
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = largeUnit) uniform usamplerBuffer largeList;
layout(binding = counterUnit) uniform usamplerBuffer largeCounts;
#else
layout(local_size_x = 64) in;
layout(std430, binding = largeBinding) restrict buffer LargeBlock { uint large[]; };
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint counters[]; };
#include "draw/exact/list_place.glsl"
#endif
#include "draw/exact/instances/box.glsl"

Rays raysOfView() {
  return Rays(view.ray.xyz, view.rayAcross.xyz, view.rayDown.xyz);
}

#ifdef LARGE
void addLarge(int number) {
  GlowDisc glow = glowDiscOf(number);
  Rays rays = raysOfView();
  ivec4 box = glow.box;
  int across = (box.z - box.x) / tileSide + 1;
  int tiles = across * ((box.w - box.y) / tileSide + 1);
  for (int tile = int(gl_WorkGroupID.z); tile < tiles; tile += int(gl_NumWorkGroups.z)) {
    ivec2 pixel = box.xy + ivec2(tile % across, tile / across) * tileSide + ivec2(gl_LocalInvocationID.xy);
    if (pixel.x <= box.z && pixel.y <= box.w) addGlow(glow, rays, pixel);
  }
}

#ifdef MEDIUM
void addMedium(int number) {
  GlowDisc glow = glowDiscOf(number);
  Rays rays = raysOfView();
  ivec4 box = glow.box;
  int across = box.z - box.x + 1, pixels = pixelsIn(box);
  for (int i = int(gl_LocalInvocationIndex); i < pixels; i += 64) addGlow(glow, rays, box.xy + ivec2(i % across, i / across));
}

void addMediums() {
  uint count = texelFetch(largeCounts, draws + draw_).x, groups = gl_NumWorkGroups.x * gl_NumWorkGroups.z;
  for (uint entry = gl_WorkGroupID.z * gl_NumWorkGroups.x + gl_WorkGroupID.x; entry < count; entry += groups)
    addMedium(int(texelFetch(largeList, firstLarge + capacity - 1 - int(entry)).x));
}
#endif

void main() {
#ifdef MEDIUM
  addMediums();
#endif
  uint count = texelFetch(largeCounts, draw_).x, groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y;
  for (uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; entry < count; entry += groups)
    addLarge(int(texelFetch(largeList, firstLarge + int(entry)).x));
}
#else
void main() {
  int number = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (number >= capacity) return;
  GlowDisc glow = glowDiscOf(number);
  ivec4 box = glow.box;
  if (box.z < box.x || box.w < box.y) return;
  if (max(box.z - box.x, box.w - box.y) >= smallPixels) {
#ifdef MEDIUM
    if (max(box.z - box.x, box.w - box.y) < mediumPixels)
      large[firstLarge + capacity - 1 - int(nextPlace(draws + draw_))] = uint(number);
    else
#endif
    large[firstLarge + int(nextPlace(draw_))] = uint(number);
    return;
  }
  Rays rays = raysOfView();
  ivec2 pixel = box.xy;
  int pixels = pixelsIn(box);
  for (int i = 0; i < pixels; ++i) {
    addGlow(glow, rays, pixel);
    pixel = nextIn(box, pixel);
  }
}
#endif
