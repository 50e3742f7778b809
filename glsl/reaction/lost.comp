// Which of the steps of passes of several was the first to lose a cell (strips.glsl).
#include "common/status.glsl"
#include "reaction/bindings.glsl"
layout(local_size_x = 1) in;
layout(std430, binding = sumBinding) restrict readonly buffer LostBlock { uint lostCells[]; };
uniform int lostFirst, count;

void main() {
  for (int i = 0; i < count; ++i) {
    if (lostCells[i] == 0xffffffffu) continue;
    noteLost(uint(lostFirst + i), lostCells[i]);
    return;
  }
}
