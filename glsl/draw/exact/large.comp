// Triangles that are large, or reach beyond the picture's surroundings: those that triangles.comp has listed. A group
// takes every so manyth tile of one. SAMPLES, PASS, SUN_MAP, COUNTED.
#include "draw/exact/raster.glsl"
#include "draw/exact/fill_tiles.glsl"
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
uniform int draw_;

void drawLarge(int number) {
  ivec3 corners = cornersOf(number);
  uvec4 a = texelFetch(vertices, corners.x), b = texelFetch(vertices, corners.y), c = texelFetch(vertices, corners.z);
#ifndef SUN_MAP
  float nearest = view.near;
#endif
  Polygon p = clippedToPicture(placeOf(a), placeOf(b), placeOf(c), vec2(PICTURE_SIZE), nearest);
  for (int k = 1; k + 1 < p.count; ++k) {
#ifdef SUN_MAP
    Triangle t = drawnTriangle(cornerOfVertex(a), cornerOfVertex(b), cornerOfVertex(c));  // never clipped
    if (k > 1) break;
#else
    Triangle t = drawnTriangle(cornerOf(p.corners[0], nearest), cornerOf(p.corners[k], nearest),
                               cornerOf(p.corners[k + 1], nearest));
#endif
    fillTiles(t, firstId + uint(number));
  }
}

void main() {
  uint count = texelFetch(counters, draw_).x, groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y;
  for (uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; entry < count; entry += groups)
    drawLarge(int(texelFetch(large, firstIndex / 3 + int(entry)).x));
}
