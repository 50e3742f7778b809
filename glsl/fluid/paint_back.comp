// Copies the cells that paint.comp has painted back to the main arrays. One invocation per cell.
#define NEXT_FLOW
#define NEXT_DYE
#define READS_DYE
#include "fluid/grid.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
uniform ivec4 box;  // Painted cells: first column, first row, number of columns, number of rows; may include cells of
                    // the ring

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= box.z || at.y >= box.w) return;
  int x = at.x + box.x, y = at.y + box.y, element = elementOf(x, y);
  storeNext(x, y, flowIn(element));
  storeDye(element, LOAD_CELL(dye, element));
}
