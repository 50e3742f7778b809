// The uv of a spot of a surface, and how they change over a pixel. GRID: from the numbers of its vertices.
#ifdef GRID
#include "common/once.glsl"
uniform ivec2 grid;
ivec2 grid_ = once(grid);
uniform vec2 perGrid;  // 1 / (grid - 1)
vec2 perGrid_ = once(perGrid);
uniform float perRow;  // 1 / grid.x
float perRow_ = once(perRow);

vec2 uvOf(int vertex) {
  // Software drivers divide integers lane by lane. In floats the quotient is off by one at most, of up to five million rows.
  int i = vertex - firstVertex_;
  precise float about = float(i) * perRow_;
  int row = int(about);
  row += (i < row * grid_.x ? -1 : 0) + (i >= row * grid_.x + grid_.x ? 1 : 0);
  precise vec2 uv = vec2(i - row * grid_.x, row) * perGrid_;
  return uv;
}
#else
layout(binding = uvUnit) uniform samplerBuffer uvs;

vec2 uvOf(int vertex) {
  return texelFetch(uvs, vertex - firstVertex_).xy;
}
#endif

Seen seenByUv(Spot spot, vec2 repeats) {
  vec2 a = uvOf(spot.corners.x), b = uvOf(spot.corners.y), c = uvOf(spot.corners.z);
  vec3 w = spot.weight, right = weightsBeside(spot, vec2(1, 0)), above = weightsBeside(spot, vec2(0, -1));
  precise vec2 at = (w.x * a + w.y * b + w.z * c) * repeats;
  precise vec2 across = (right.x * a + right.y * b + right.z * c) * repeats - at;
  precise vec2 up = (above.x * a + above.y * b + above.z * c) * repeats - at;
  Seen seen;
  seen.at = at;
  seen.across = across;
  seen.up = up;
  return seen;
}
