// Buffer used by all kernels of the pressure solver. Speeds and divergences are stored as float bits, because the bits
// of non-negative floats compare like integers.
layout(std430, binding = controlBinding) restrict buffer ControlBlock {
  uint flow;        // Maximum remaining divergence of a cell
  uint speed;       // Maximum |u| or |v|, also of the flow before the projection
  uint cycles;      // Total number of cycles
  uint solved;      // Total number of projections
  uint worstShare;  // Maximum of lastShare so far
  uint worstSpeed;  // Maximum of lastSpeed so far
  uint lastShare;   // Ratio of `flow` to `speed` after the latest projection
  uint lastSpeed;   // Maximum |u| or |v| of the flow after the latest projection
  uint begun;       // Number of cycles of the current projection so far
  uint groups[];    // Three words per indirect dispatch: first the current sizes of all dispatches, then their sizes
                    // for a cycle
} control;

// Records three maxima: remaining divergence, |u| or |v|, and |u| or |v| of the final state. Every invocation of a
// workgroup of 64 must call it exactly once, with zeros if it has nothing to record. On GPUs, a workgroup first reduces
// in shared memory, because atomic access of all invocations to one word is a bottleneck.
#ifndef TEXEL_PATH
shared uint flowsOfGroup[64], speedsOfGroup[64], fastestOfGroup[64];
#endif
void noteMaximum(float flow, float speed, float fastest) {
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

// Records only the maximum of the remaining divergence.
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
