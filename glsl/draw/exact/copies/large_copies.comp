// Rasterizes the triangles of mesh copies in the list of copies.comp that are large or extend far beyond the picture.
// For each triangle, the workgroups split the tiles between them. Defines: as for raster_triangle.glsl.
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
