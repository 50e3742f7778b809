// Computes a fluid's wind at each cell of a wildfire's map. The fluid's rectangle is stretched over the map. One
// invocation per element of four cells.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/wind_array.glsl"
#include "spread/bindings.glsl"
#include "spread/wildfire/gale.glsl"
layout(local_size_x = 64) in;
STATE_WORDS(nextCellsBinding, GaleBlock, gales)
uniform ivec2 size;      // Number of cells of the map per axis
uniform vec2 perCell;    // Number of cells of the fluid per cell of the map
uniform float scale;
uniform int rowGales;    // Number of elements per row
uniform int count;

uint galeIn(int x, int y) {
  precise float px = (float(x) + 0.5f) * perCell.x;
  precise float py = (float(y) + 0.5f) * perCell.y;
  px = min(px, float(windGrid.size.x));
  py = min(py, float(windGrid.size.y));
  return x < size.x ? galeOf(windPart(0, px, py), windPart(1, px, py), scale) : stillAir;
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  int y = i / rowGales, x = 4 * (i % rowGales);
  STORE_WORDS(gales, i, uvec4(galeIn(x, y), galeIn(x + 1, y), galeIn(x + 2, y), galeIn(x + 3, y)));
}
