// Rasterizes the large triangles of mesh copies, and those that extend far beyond the picture, from the list of
// copies.comp. Workgroups share the tiles of each triangle in turn. Variants of raster_triangle.glsl.
#include "draw/exact/copies/raster_copy.glsl"
#include "draw/exact/triangles/fill_fan.glsl"
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
uniform int part;

void drawLarge(uint pair) {
  CopyTriangle c = copyTriangle(pair);
#ifdef SUN_MAP
  // Triangles in the sun's shadow map need no clipping.
  fillTiles(drawnTriangle(cornerAt(c.a, c.na), cornerAt(c.b, c.nb), cornerAt(c.c, c.nc)), c.id);
#else
  fillClipped(c.a, c.b, c.c, view.near, c.id);
#endif
}

void main() {
  uint count = texelFetch(counters, part).x, groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y;
  for (uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; entry < count; entry += groups)
    drawLarge(texelFetch(large, int(entry)).x);
}
