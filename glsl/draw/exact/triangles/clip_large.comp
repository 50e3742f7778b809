// Clips the large triangles of one surface that triangles.comp has listed, one per invocation. BINS: lists the clipped
// triangles by tile, and appends triangles for which there is no room to another list. LAMP_MAP: as in
// draw/exact/visible_sample.glsl. COUNTED: the GPU has written the number of triangles to the draw arguments.
#ifdef BINS
#include "draw/exact/triangles/raster.glsl"
#include "draw/exact/triangles/crossing.glsl"
#define MAKES_BINS
#include "draw/exact/triangles/bins.glsl"
#else
#include "draw/exact/triangles/surface_triangle.glsl"
#include "draw/exact/view_block.glsl"
#endif
#define MAKES_FANS
#include "draw/exact/triangles/fans.glsl"
layout(local_size_x = 64) in;
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
#ifdef FACES
int draw_ = face_;
#else
uniform int draw_;
#endif
#ifdef BINS
layout(std430, binding = largeBinding) writeonly restrict buffer LargeBlock { uint left[]; };
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint leftCounts[]; };
uniform int draws;

bool binFan(vec3 a, vec3 b, vec3 c, uint id) {
  Polygon p = clippedToPicture(a, b, c, vec2(view.size), view.near);
  bool room = true;
  for (int k = 1; k + 1 < p.count; ++k) {
    Triangle t = drawnTriangle(cornerOf(p.corners[0], view.near), cornerOf(p.corners[k], view.near),
                               cornerOf(p.corners[k + 1], view.near));
    if (!t.empty && room) room = bin(t, id);
  }
  return room;
}
#endif

void clipLarge(int entry) {
  int number = int(texelFetch(large, firstIndex / 3 + entry).x);
  ivec3 corners = cornersOf(number);
  uvec4 a = vertexOf(corners.x), b = vertexOf(corners.y), c = vertexOf(corners.z);
#ifdef BINS
  seeSides(number);
  if (binFan(drawnPlace(a), drawnPlace(b), drawnPlace(c), firstId + uint(number))) return;
  entry = int(atomicAdd(leftCounts[draws + draw_], 1u));
  left[firstIndex / 3 + entry] = uint(number);
  if (entry >= fanRoom) return;
#endif
  makeFan(entry, drawnPlace(a), drawnPlace(b), drawnPlace(c), vec2(view.size), view.near);
}

void main() {
  int entry = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  int count = int(texelFetch(counters, draw_).x);
#ifndef BINS
  count = min(count, fanRoom);
#endif
#ifdef FACES
  for (entry = int(gl_GlobalInvocationID.x); entry < count; entry += int(gl_NumWorkGroups.x) * 64) clipLarge(entry);
#else
  if (entry < count) clipLarge(entry);
#endif
}
