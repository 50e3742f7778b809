// Returns the uv of a surface's vertex. GRID: computes the uv from the vertex index.
#include "draw/bindings.glsl"
#ifdef GRID
#include "common/once.glsl"
uniform ivec2 grid;
ivec2 grid_ = once(grid);
uniform vec2 perGrid;  // 1 / (grid - 1), the factor that converts grid coordinates to uv
vec2 perGrid_ = once(perGrid);
uniform float perRow;  // 1 / number of vertices in a row of the grid
float perRow_ = once(perRow);

vec2 uvOf(int vertex) {
  // Divides in float, because software drivers divide integers lane by lane. The quotient is off by at most one for up
  // to five million rows.
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
