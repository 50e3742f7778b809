// Rasterizes the triangles in the list of triangles.comp that are large or extend far beyond the picture. For each
// triangle, the workgroups split the tiles between them. CLIPS: handles only the triangles for which clip_large.comp
// had no room. This is a separate program because software drivers would execute the clipping for all triangles. BINS:
// handles the triangles that clip_large.comp could not list by tile. SAMPLES, PASS, SUN_MAP: as in
// draw/exact/visible_sample.glsl. COUNTED: the GPU has written the number of triangles to the draw arguments.
#include "draw/exact/triangles/raster.glsl"
#include "draw/exact/triangles/fill_fan.glsl"
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
#ifdef FACES
int draw_ = face_;
const uint groupRow = 0u, groupRows = 1u;
#else
uniform int draw_;
uint groupRow = gl_WorkGroupID.y, groupRows = gl_NumWorkGroups.y;
#endif

#if defined BINS && !defined SUN_MAP
uniform int draws;
#else
const int draws = 0;
#endif

void drawLarge(int entry) {
  int number = int(texelFetch(large, firstIndex / 3 + entry).x);
  uint id = firstId + uint(number);
  seeSides(number);
#if defined SUN_MAP || defined CLIPS
  ivec3 corners = cornersOf(number);
  uvec4 a = vertexOf(corners.x), b = vertexOf(corners.y), c = vertexOf(corners.z);
#ifdef CUTOUT
  cutTriangle(corners, placeOf(a), placeOf(b), placeOf(c));
#endif
#ifdef SUN_MAP
  // Triangles in the sun's shadow map need no clipping.
  fillTiles(drawnTriangle(cornerOfVertex(a), cornerOfVertex(b), cornerOfVertex(c)), id);
#else
  fillClipped(drawnPlace(a), drawnPlace(b), drawnPlace(c), view.near, id);
#endif
#else
  fillFan(entry, id);
#endif
}

void main() {
  uint first = 0u, count = texelFetch(counters, draws + draw_).x, groups = gl_NumWorkGroups.x * groupRows;
#ifdef CLIPS
  first = uint(fanRoom);
#elif !defined SUN_MAP
  count = min(count, uint(fanRoom));
#endif
  for (uint entry = first + groupRow * gl_NumWorkGroups.x + gl_WorkGroupID.x; entry < count; entry += groups)
    drawLarge(int(entry));
}
