// What paint.comp has painted of a rectangle, to where the rest of the cells are.
#include "common/memory.glsl"
#include "fluid/bindings.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
INPUT_ARRAY(flowBinding, FlowBlock, paintedFlow)
INPUT_ARRAY(dyeBinding, DyeBlock, paintedDye)
STATE_ARRAY(nextFlowBinding, NextFlowBlock, flow)
STATE_ARRAY(nextDyeBinding, NextDyeBlock, dye)
uniform ivec4 box;  // cells: first column and row, how many of each; the ring counts
uniform ivec2 size;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= box.z || at.y >= box.w) return;
  int element = (at.y + box.y + 1) * (size.x + 2) + at.x + box.x + 1;
  STORE_STATE(flow, element, LOAD_INPUT(paintedFlow, element));
  STORE_STATE(dye, element, LOAD_INPUT(paintedDye, element));
}
