// Rasterizes balls into the sun's shadow map, as discs that face the sun, one per invocation. Appends large discs to a
// list. LARGE: rasterizes the listed discs; for each disc, the workgroups split the tiles between them. Requires
// SAMPLES 1 and PASS 0.
#define EXACT_PICTURE
#include "draw/frame_block.glsl"
#include "draw/exact/visible_sample.glsl"
#include "draw/exact/triangles/triangle.glsl"
#include "draw/exact/light_place.glsl"
#include "draw/exact/instances/instance_source.glsl"
#include "draw/exact/instances/disc.glsl"
uniform int draw_;
uniform int firstLarge;
uniform int smallPixels;
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

Disc discOf(int number, out uint key) {
  vec4 position = texelFetch(positions, number);
  vec3 place = lightPlace(position.xyz);
  Disc disc;
  precise vec2 middle = place.xy * float(mapTexels);
  precise float radius = radiusOf(position, texelFetch(velocities, number)) * exactReciprocal(lightTexel());
  disc.middle = middle;
  disc.radius = radius;
  precise float near = 1.0f - place.z - 4e-7f;  // depth offset, equal to that of triangles without slope in
                                                // raster_triangle.glsl
  key = nearKey(max(near, 0.0f));
  return disc;
}

void put(Disc disc, ivec2 texel, uint key) {
  int at = texel.y * mapTexels + texel.x;
  if (onDisc(disc, texel)) keep(at, key, keyAt(at), 0u);
}

#ifdef LARGE
void drawLarge(int number) {
  uint key;
  Disc disc = discOf(number, key);
  ivec4 box = pixelsOfDisc(disc, ivec2(mapTexels));
  int across = (box.z - box.x) / tileSide + 1;
  int tiles = across * ((box.w - box.y) / tileSide + 1);
  for (int tile = int(gl_WorkGroupID.z); tile < tiles; tile += int(gl_NumWorkGroups.z)) {
    ivec2 texel = box.xy + ivec2(tile % across, tile / across) * tileSide + ivec2(gl_LocalInvocationID.xy);
    if (texel.x <= box.z && texel.y <= box.w) put(disc, texel, key);
  }
}

void main() {
  uint count = texelFetch(largeCounts, draw_).x, groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y;
  for (uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; entry < count; entry += groups)
    drawLarge(int(texelFetch(largeList, firstLarge + int(entry)).x));
}
#else
// Returns true if the disc equals the previous one, which then writes the same texels. Unused elements of a buffer are
// often equal, and each may be as large as the whole map.
bool equalsPrevious(int number) {
  return number > 0 && texelFetch(positions, number) == texelFetch(positions, number - 1) &&
         texelFetch(velocities, number) == texelFetch(velocities, number - 1);
}

void main() {
  int number = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (number >= capacity || equalsPrevious(number)) return;
  uint key;
  Disc disc = discOf(number, key);
  ivec4 box = pixelsOfDisc(disc, ivec2(mapTexels));
  if (!(disc.radius > 0.0f) || box.z < box.x || box.w < box.y) return;
  if (max(box.z - box.x, box.w - box.y) >= smallPixels) {
    large[firstLarge + int(nextPlace(draw_))] = uint(number);
    return;
  }
  ivec2 texel = box.xy;
  int texels = (box.z - box.x + 1) * (box.w - box.y + 1);
  for (int i = 0; i < texels; ++i) {
    put(disc, texel, key);
    texel = texel.x < box.z ? ivec2(texel.x + 1, texel.y) : ivec2(box.x, texel.y + 1);
  }
}
#endif
