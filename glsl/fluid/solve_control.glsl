// What the kernels that solve for the pressure tell each other. Speeds and flows are the bits of floats that are not
// negative, which compare as integers do.
layout(std430, binding = controlBinding) restrict buffer ControlBlock {
  uint flow;        // the most that is missing in a cell
  uint speed;       // the most of |u|, |v|, of the flow before its projection, too
  uint cycles;      // of all projections so far
  uint solved;      // projections so far
  uint worstShare;  // flow / speed after a projection, the most so far,
  uint worstSpeed;  // and of speeds
  uint lastShare;   // of the latest projection
  uint lastSpeed;   // the most of |u|, |v| of the projected flow, which is the state
  uint groups[];    // three for each indirect dispatch: as they are now, then as a cycle wants them
} control;

void noteMost(float flow, float speed) {
  uint flowBits = floatBitsToUint(flow), speedBits = floatBitsToUint(speed);
  if (flowBits > control.flow) atomicMax(control.flow, flowBits);
  if (speedBits > control.speed) atomicMax(control.speed, speedBits);
}

// The most of |u|, |v| of the state.
void noteSpeed(float speed) {
  uint bits = floatBitsToUint(speed);
  if (bits > control.lastSpeed) atomicMax(control.lastSpeed, bits);
}
