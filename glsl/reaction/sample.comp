// Samples another object's field on the grid of a rule, as the map of a parameter. Interpolates bilinearly between cell
// centres, with the same values for all layers of a volume. If LAYERS is defined, samples another volume trilinearly.
// If MESH is defined, each cell has a separate position in the field, or the field belongs to the same cells
// (`byCell`). One invocation per element of four cells of one layer.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "reaction/bindings.glsl"
#include "reaction/functions.glsl"
#include "reaction/sampling.glsl"
layout(local_size_x = 16, local_size_y = 4) in;
STATE_ARRAY(nextBinding, MapBlock, maps)
const int fieldUnit = stageBinding;
#include "grid/field.glsl"
uniform ivec2 size;
uniform int columns, depth, plane;
#ifdef LAYERS
uniform int fieldLayers;  // Number of layers of the field, which are stored one after another in its rows
#endif
uniform float storedGrain;
#ifdef MESH
// For each cell: position from the left in the lower 16 bits, from the top in the upper 16 bits
INPUT_WORDS(linksBinding, PlaceBlock, places)
uniform int byCell;
#endif

float storedValueAt(int x, int y) {
  return grained(valueAt(ivec2(x, y)), storedGrain);
}

// Interpolates between the rows of the layer that begins at row `top`.
float inLayer(Between across, Between down, int top) {
  float above = betweenOf(storedValueAt(across.before, top + down.before), storedValueAt(across.after, top + down.before), across.share);
  float below = betweenOf(storedValueAt(across.before, top + down.after), storedValueAt(across.after, top + down.after), across.share);
  return betweenOf(above, below, down.share);
}

#ifdef LAYERS
void main() {
  int x = int(gl_GlobalInvocationID.x), row = int(gl_GlobalInvocationID.y);
  if (x >= columns || row >= size.y * depth) return;
  int rows = fieldSize.y / fieldLayers;
  Between down = betweenCells(row % size.y, size.y, rows);
  Between deep = betweenCells(row / size.y, depth, fieldLayers);
  vec4 four = vec4(0);
  for (int i = 0; i < 4; ++i) {
    if (4 * x + i >= size.x) continue;
    Between across = betweenCells(4 * x + i, size.x, fieldSize.x);
    float before = inLayer(across, down, deep.before * rows), after = inLayer(across, down, deep.after * rows);
    four[i] = grained(betweenOf(before, after, deep.share), storedGrain);
  }
  STORE_STATE(maps, (plane * depth * size.y + row) * columns + x, four);
}
#else
void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  if (x >= columns || y >= size.y) return;
  vec4 four = vec4(0);
#ifdef MESH
  uvec4 places4 = LOAD_INPUT_WORDS(places, x);
#else
  Between down = betweenCells(y, size.y, fieldSize.y);
#endif
  for (int i = 0; i < 4; ++i) {
    if (4 * x + i >= size.x) continue;
#ifdef MESH
    if (byCell != 0) {
      four[i] = storedValueAt(4 * x + i, 0);
      continue;
    }
    Between across = betweenAt(int(places4[i] & 65535u), fieldSize.x);
    Between down = betweenAt(int(places4[i] >> 16u), fieldSize.y);
#else
    Between across = betweenCells(4 * x + i, size.x, fieldSize.x);
#endif
    four[i] = grained(inLayer(across, down, 0), storedGrain);
  }
  for (int z = 0; z < depth; ++z) STORE_STATE(maps, ((plane * depth + z) * size.y + y) * columns + x, four);
}
#endif
