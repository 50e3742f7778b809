// Rasterizes the medium-sized triangles of mesh copies, which are at the end of the list of copies.comp. Sixteen
// invocations handle one triangle. Defines: as for raster_triangle.glsl.
#include "draw/exact/copies/raster_copy.glsl"
#include "draw/exact/triangles/fill_blocks.glsl"
layout(local_size_x = 64) in;
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
uniform int part;
uniform int parts;
uniform int listRoom;

void main() {
  const uint teams = 64u / teamSize;
  uint count = texelFetch(counters, parts + part).x, me = gl_LocalInvocationIndex;
  for (uint entry = gl_WorkGroupID.x * teams + me / teamSize; entry < count; entry += gl_NumWorkGroups.x * teams) {
    CopyTriangle c = copyTriangle(texelFetch(large, listRoom - 1 - int(entry)).x);
    Triangle t = drawnTriangle(cornerAt(c.a, c.na), cornerAt(c.b, c.nb), cornerAt(c.c, c.nc));
    fillBlocks(t, c.id, me % teamSize);
  }
}
