// Triangles that are large, or reach beyond the picture's surroundings: those that triangles.comp has listed. A group
// takes every PARTS-th tile of one. SAMPLES, PASS, SUN_MAP, COUNTED; PARTS.
#include "draw/exact/raster.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
uniform int draw_;

// Whether some sample of the tile around `middle` may be on the inner side.
bool reachesTile(Edge edge, ivec2 middle) {
  return edgeOverSixteen(edge, middle) + (abs(edge.step_.x) + abs(edge.step_.y)) * (8 * tileSide) >= 0;
}

void fill(Triangle t, uint id) {
  ivec2 first = max(t.low >> 8, ivec2(0)) / tileSide;
  ivec2 last = min(t.high >> 8, PICTURE_SIZE - 1) / tileSide;
  ivec2 across = last - first + 1;
  int tiles = t.empty || across.x <= 0 || across.y <= 0 ? 0 : across.x * across.y;
  for (int tile = int(gl_WorkGroupID.z); tile < tiles; tile += PARTS) {
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
    if (pixel.x < PICTURE_SIZE.x && pixel.y < PICTURE_SIZE.y) putPixel(t, pixel, mask, id);
  }
}

void main() {
  uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (entry >= texelFetch(counters, draw_).x) return;
  int number = int(texelFetch(large, firstIndex / 3 + int(entry)).x);
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
    fill(t, firstId + uint(number));
  }
}
