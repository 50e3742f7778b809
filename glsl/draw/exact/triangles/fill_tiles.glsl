// Rasterizes a triangle tile by tile. Workgroups of 8 by 8 invocations split the tiles between them.
#include "draw/exact/triangles/raster_triangle.glsl"
#include "draw/exact/triangles/crossing.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

void fillTile(Triangle t, ivec2 corner, uint id) {
  ivec2 pixel = corner + ivec2(gl_LocalInvocationID.xy), at = pixel * subpixels;
  int e0 = edgeOverSixteen(t.edges[0], at), e1 = edgeOverSixteen(t.edges[1], at), e2 = edgeOverSixteen(t.edges[2], at);
  int mask = 0;
  for (int s = 0; s < SAMPLES; ++s) {
    ivec2 aside = samplePlace(s);
    int all_ = edgeAside(t.edges[0], e0, aside) | edgeAside(t.edges[1], e1, aside) | edgeAside(t.edges[2], e2, aside);
    mask |= all_ >= 0 ? 1 << s : 0;
  }
  if (mask != 0 && pixel.x < PICTURE_SIZE.x && pixel.y < PICTURE_ROWS.y) putPixel(t, pixel, mask, id);
}

// Workgroups split the tiles by rows and, if there are many workgroups, also by columns.
void fillTiles(Triangle t, uint id) {
  ivec2 first = max(t.low / subpixels, ivec2(0, PICTURE_ROWS.x)) / tileSide;
  ivec2 last = min(t.high / subpixels, ivec2(PICTURE_SIZE.x, PICTURE_ROWS.y) - 1) / tileSide;
  bool none = t.empty || t.high.x < 0 || t.high.y < 0;
  int columns = gl_NumWorkGroups.z >= 32u ? 4 : 1, rows = int(gl_NumWorkGroups.z) / columns;
  int row = int(gl_WorkGroupID.z) / columns, column = int(gl_WorkGroupID.z) - row * columns;
  if (row >= rows) return;
  Crossing a = crossingOf(t.edges[0]), b = crossingOf(t.edges[1]), c = crossingOf(t.edges[2]);
  int end = none ? -1 : last.y;
  for (int y = first.y + row; y <= end; y += rows) {
    ivec2 span = ivec2(first.x, last.x);
    span = tilesBetween(span, t.edges[0], a, y);
    span = tilesBetween(span, t.edges[1], b, y);
    span = tilesBetween(span, t.edges[2], c, y);
    for (int x = span.x + column; x <= span.y; x += columns) fillTile(t, ivec2(x, y) * tileSide, id);
  }
}
