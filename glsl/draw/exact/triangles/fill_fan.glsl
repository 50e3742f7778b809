// Rasterizes large triangles from a list. Defines: as for raster_triangle.glsl.
#include "draw/exact/triangles/fill_tiles.glsl"
#ifndef SUN_MAP
#include "draw/exact/triangles/fans.glsl"

// Rasterizes a fan that is already clipped.
void fillFan(int entry, uint id) {
  int corners = cornersOfFan(entry);
  Corner first = cornerOfFan(entry, 0), before = cornerOfFan(entry, 1);
  for (int k = 2; k < corners; ++k) {
    Corner next = cornerOfFan(entry, k);
    fillTiles(drawnTriangle(first, before, next), id);
    before = next;
  }
}

void fillClipped(vec3 a, vec3 b, vec3 c, float nearest, uint id) {
  Polygon p = clippedToPicture(a, b, c, vec2(PICTURE_SIZE), nearest);
  for (int k = 1; k + 1 < p.count; ++k)
    fillTiles(drawnTriangle(cornerOf(p.corners[0], nearest), cornerOf(p.corners[k], nearest),
                            cornerOf(p.corners[k + 1], nearest)),
              id);
}
#endif
