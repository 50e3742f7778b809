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
  uint begun;       // cycles of this projection
  uint groups[];    // three for each indirect dispatch: as they are now, then as a cycle wants them
} control;

// Of a whole work group, of 64: each of its invocations calls this once, with zeros where it has nothing to tell. What is
// missing, the most of |u|, |v|, and that of the state. A group joins on a GPU, where a word that all invocations
// change is what they wait for.
#ifndef TEXEL_PATH
shared uint flowsOfGroup[64], speedsOfGroup[64], fastestOfGroup[64];
#endif
void noteMost(float flow, float speed, float fastest) {
  uint flowBits = floatBitsToUint(flow), speedBits = floatBitsToUint(speed), fastestBits = floatBitsToUint(fastest);
#ifndef TEXEL_PATH
  int lane = int(gl_LocalInvocationIndex);
  flowsOfGroup[lane] = flowBits;
  speedsOfGroup[lane] = speedBits;
  fastestOfGroup[lane] = fastestBits;
  for (int others = 32; others > 0; others >>= 1) {
    barrier();
    if (lane < others) {
      flowsOfGroup[lane] = max(flowsOfGroup[lane], flowsOfGroup[lane + others]);
      speedsOfGroup[lane] = max(speedsOfGroup[lane], speedsOfGroup[lane + others]);
      fastestOfGroup[lane] = max(fastestOfGroup[lane], fastestOfGroup[lane + others]);
    }
  }
  if (lane > 0) return;
  flowBits = flowsOfGroup[0];
  speedBits = speedsOfGroup[0];
  fastestBits = fastestOfGroup[0];
#endif
  if (flowBits > control.flow) atomicMax(control.flow, flowBits);
  if (speedBits > control.speed) atomicMax(control.speed, speedBits);
  if (fastestBits > control.lastSpeed) atomicMax(control.lastSpeed, fastestBits);
}

// The same of what is missing alone.
void noteMissing(float flow) {
  uint flowBits = floatBitsToUint(flow);
#ifndef TEXEL_PATH
  int lane = int(gl_LocalInvocationIndex);
  flowsOfGroup[lane] = flowBits;
  for (int others = 32; others > 0; others >>= 1) {
    barrier();
    if (lane < others) flowsOfGroup[lane] = flowBits = max(flowBits, flowsOfGroup[lane + others]);
  }
  if (lane > 0) return;
#endif
  if (flowBits > control.flow) atomicMax(control.flow, flowBits);
}
