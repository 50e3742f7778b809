// Finds the first step with a lost cell, after passes of several steps (strips.glsl). One invocation in total.
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
