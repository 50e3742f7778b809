// Applies all active brushes to the cells of a box, one invocation per cell. firstBrush and endBrush are uniform, so
// all invocations loop over the same brushes.
#define NEXT_FLOW
#define NEXT_DYE
#define READS_DYE
#include "common/hash.glsl"
#include "fluid/grid.glsl"
#include "grid/stroke.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
INPUT_WORDS(stampsBinding, StampBlock, stamps)
layout(std140, binding = brushesBinding) uniform BrushBlock { FluidBrush brushes[maxBrushes]; };
uniform int firstBrush, endBrush;  // Index range of the brushes that affect cells of the box
// Cells that may change: first column, first row, number of columns, number of rows; may include cells of the ring
uniform ivec4 box;

bool brushPaints(int i, ivec2 cell) {
  ivec2 inBox = cell - brushes[i].box.xy;
  if (any(lessThan(inBox, ivec2(0))) || any(greaterThanEqual(inBox, brushes[i].box.zw))) return false;
  FluidBrush b = brushes[i];
  Stroke stroke;
  stroke.from = b.segment.xy;
  stroke.to = b.segment.zw;
  stroke.radius2 = b.reach.x;
  stroke.perLength2 = b.reach.y;
  stroke.value = b.reach.z;
  stroke.seed = b.stamp.x;
  stroke.picked = b.stamp.y;
  if (!strokePicks(stroke, cell)) return false;
  if (b.image.z == 0) return strokeReaches(stroke, cell);
  ivec2 at = cell - b.image.xy;
  if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, b.image.zw))) return false;
  int bit = at.y * b.image.z + at.x;
  int word = b.stamp.z + (bit >> 5);
  return (LOAD_INPUT_WORDS(stamps, word >> 2)[word & 3] >> uint(bit & 31) & 1u) != 0u;
}
#include "fluid/brush.glsl"

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= box.z || at.y >= box.w) return;
  int x = at.x + box.x, y = at.y + box.y;
  storeNext(x, y, paintedCell(x, y));
  storeDye(elementOf(x, y), paintedDye(x, y));
}
