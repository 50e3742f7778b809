// Applies a brush stroke in a volume or on a mesh: a species gets the stroke's value. One invocation per element of
// four cells, in those rows of a volume that the stroke's bounding box covers, or in the single row of a mesh.
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "grid/stroke.glsl"
#include "reaction/bindings.glsl"
#include "reaction/brush.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(nextBinding, CellBlock, cells)
#ifdef MESH
INPUT_ARRAY(weightsBinding, MapBlock, maps)  // The last three planes hold the cells' positions.
uniform int places;  // Index of the first plane with positions
#endif
uniform Stroke stroke;
uniform Brush brush;
uniform ivec2 size;     // Number of cells per axis
uniform ivec4 boxRows;  // First y and number of rows, first z and number of layers
uniform int columns, depth, plane;

void main() {
  int x = int(gl_GlobalInvocationID.x), item = int(gl_GlobalInvocationID.y);
  if (x >= columns || item >= boxRows.y * boxRows.w) return;
  int y = boxRows.x + item % boxRows.y, z = boxRows.z + item / boxRows.y;
  int row = z * size.y + y;
  int element = (plane * depth * size.y + row) * columns + x;
#ifdef MESH
  vec4 across = LOAD_INPUT(maps, places * columns + x);
  vec4 up = LOAD_INPUT(maps, (places + 1) * columns + x);
  vec4 deep = LOAD_INPUT(maps, (places + 2) * columns + x);
#endif
  vec4 four = LOAD_STATE(cells, element);
  for (int i = 0; i < 4; ++i) {
    int cell = 4 * x + i;
#ifdef MESH
    vec3 place = vec3(across[i], up[i], deep[i]);
#else
    precise vec3 place = vec3(cell, y, z) + 0.5f;
#endif
    if (cell < size.x && strokePicks(stroke, ivec2(cell, row)) && brushReaches(brush, place)) four[i] = stroke.value;
  }
  STORE_STATE(cells, element, four);
}
