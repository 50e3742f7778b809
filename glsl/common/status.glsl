// Status block in which a simulation records the first step and element whose state is not a finite number.
#include "common/bindings.glsl"
layout(std430, binding = statusBinding) restrict buffer StatusBlock {
  uint firstStep;     // step of the first non-finite state; 0xffffffff until one occurs
  uint firstElement;  // lowest index of all non-finite elements in that first step
  uint remark;        // nonzero if the simulation has a remark for the user (Simulation::remark)
  uint spare1;
} status;

void noteLost(uint step, uint element) {
  uint before = atomicCompSwap(status.firstStep, 0xffffffffu, step);
  if (before == 0xffffffffu || before == step) atomicMin(status.firstElement, element);
}
