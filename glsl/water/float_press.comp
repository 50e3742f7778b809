// Applies the displacement and the discharge of floating bodies to the water, in a window of cells around each body. A
// cell in several windows is processed only in the first of them. One invocation per cell of a window.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "water/bindings.glsl"
#include "water/float_bindings.glsl"
#include "water/types.glsl"
#include "water/float_types.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(cellsBinding, CellBlock, cells)
INPUT_ARRAY(floatsBinding, FloatsBlock, bodies)
INPUT_ARRAY(floatParametersBinding, FloatParametersBlock, floatInput)
layout(std430, binding = floatSumsBinding) restrict buffer FloatSumBlock { ivec4 sums[]; };
layout(std140, binding = stepBinding) uniform FloatBlock { FloatStep floats; };
uniform ivec2 size;
uniform int side;   // Width of the largest window in cells
uniform int first;  // Nonzero for the initial state, which already includes the bodies

vec4 loadWater(int i) { return LOAD_STATE(cells, i); }
vec4 loadFloat(int i) { return LOAD_INPUT(bodies, i); }
vec4 loadParameters(int i) { return LOAD_INPUT(floatInput, i); }
vec4 loadFloatPoint(int i) { return vec4(0.0f); }
void addToSum(int cell, int which, int value) {}
#include "water/model.glsl"
#include "water/float_model.glsl"
#include "water/float_motion.glsl"

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  int body = y / side;
  if (x >= side || body >= floats.count) return;
  int cell = floatOwned(body, ivec2(x, y - body * side));
  if (cell < 0) return;
  ivec4 sum = sums[cell];
  if (first != 0) {
    sums[cell] = ivec4(0, 0, 0, sum.x);
    return;
  }
  if (sum.x == sum.w && sum.y == 0 && sum.z == 0) {
    if (sum.x != 0) sums[cell].x = 0;
    return;
  }
  vec4 texel = loadWater(cell);
  STORE_STATE(cells, cell, floatPressed(texel, sum));
  sums[cell] = ivec4(0, 0, 0, floatDisplaced(texel, sum));
}
