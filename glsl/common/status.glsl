// Where a simulation notes the first step and element whose state is not a number.
#include "common/bindings.glsl"
layout(std430, binding = statusBinding) restrict buffer StatusBlock {
  uint firstStep;     // 0xffffffff while all is well
  uint firstElement;  // the lowest of that step
  uint remark;        // not 0: worth a word to the user (Simulation::remark)
  uint spare1;
} status;

void noteLost(uint step, uint element) {
  uint before = atomicCompSwap(status.firstStep, 0xffffffffu, step);
  if (before == 0xffffffffu || before == step) atomicMin(status.firstElement, element);
}
