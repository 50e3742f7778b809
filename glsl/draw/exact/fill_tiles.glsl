// A triangle's pixels, a group of 8 by 8 taking every so manyth tile of it.
#include "draw/exact/raster_triangle.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

// Whether some sample of the tile around `middle` may be on the inner side.
bool reachesTile(Edge edge, ivec2 middle) {
  return edgeOverSixteen(edge, middle) + (abs(edge.step_.x) + abs(edge.step_.y)) * (8 * tileSide) >= 0;
}

void fillTiles(Triangle t, uint id) {
  ivec2 first = max(t.low >> 8, ivec2(0, PICTURE_ROWS.x)) / tileSide;
  ivec2 last = min(t.high >> 8, ivec2(PICTURE_SIZE.x, PICTURE_ROWS.y) - 1) / tileSide;
  ivec2 across = last - first + 1;
  int tiles = t.empty || across.x <= 0 || across.y <= 0 ? 0 : across.x * across.y;
  for (int tile = int(gl_WorkGroupID.z); tile < tiles; tile += int(gl_NumWorkGroups.z)) {
    ivec2 corner = (first + ivec2(tile % across.x, tile / across.x)) * tileSide;
    ivec2 middle = (corner + tileSide / 2) * subpixels;
    if (!(reachesTile(t.edges[0], middle) && reachesTile(t.edges[1], middle) && reachesTile(t.edges[2], middle)))
      continue;
    ivec2 pixel = corner + ivec2(gl_LocalInvocationID.xy);
    int e0 = edgeOverSixteen(t.edges[0], middle), e1 = edgeOverSixteen(t.edges[1], middle);
    int e2 = edgeOverSixteen(t.edges[2], middle);
    int mask = 0;
    for (int s = 0; s < SAMPLES; ++s) {
      ivec2 aside = (pixel - corner - tileSide / 2) * 16 + samplePlace(s);
      int all_ = edgeAside(t.edges[0], e0, aside) | edgeAside(t.edges[1], e1, aside) | edgeAside(t.edges[2], e2, aside);
      mask |= all_ >= 0 ? 1 << s : 0;
    }
    if (pixel.x < PICTURE_SIZE.x && pixel.y < PICTURE_ROWS.y) putPixel(t, pixel, mask, id);
  }
}
