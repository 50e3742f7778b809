// Triangles that are large, or reach beyond the picture's surroundings: those that triangles.comp has listed, and
// clip_large.comp clipped. A group takes every so manyth tile of one. SAMPLES, PASS, SUN_MAP, COUNTED.
#include "draw/exact/raster.glsl"
#include "draw/exact/fill_fan.glsl"
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
uniform int draw_;

void main() {
  uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (entry >= texelFetch(counters, draw_).x) return;
  int number = int(texelFetch(large, firstIndex / 3 + int(entry)).x);
  uint id = firstId + uint(number);
#ifndef SUN_MAP
  if (entry < uint(fanRoom)) {
    fillFan(int(entry), id);
    return;
  }
#endif
  ivec3 corners = cornersOf(number);
  uvec4 a = texelFetch(vertices, corners.x), b = texelFetch(vertices, corners.y), c = texelFetch(vertices, corners.z);
#ifdef SUN_MAP
  fillTiles(drawnTriangle(cornerOfVertex(a), cornerOfVertex(b), cornerOfVertex(c)), id);  // never clipped
#else
  fillClipped(placeOf(a), placeOf(b), placeOf(c), view.near, id);
#endif
}
