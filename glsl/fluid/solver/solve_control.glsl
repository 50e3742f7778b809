// Buffer shared by the pressure solver's kernels. Speeds and flows are float bits; non-negative floats compare like
// integers.
layout(std430, binding = controlBinding) restrict buffer ControlBlock {
  uint flow;        // Largest remaining divergence of a cell
  uint speed;       // Largest |u| or |v|, including the flow before its projection
  uint cycles;      // Total number of cycles
  uint solved;      // Total number of projections
  uint worstShare;  // Largest flow / speed after a projection so far
  uint worstSpeed;  // Largest lastSpeed so far
  uint lastShare;   // flow / speed after the latest projection
  uint lastSpeed;   // Largest |u| or |v| of the latest projected flow
  uint begun;       // Cycles of the current projection
  uint groups[];    // Three words per indirect dispatch: first the current sizes, then the sizes for a cycle
} control;

// Records maxima: remaining divergence, |u| or |v|, and |u| or |v| of the final state. Every invocation of a workgroup
// of 64 calls it once, with zeros if it has nothing to report. On GPUs a workgroup reduces in shared memory first,
// because a word that all invocations change atomically is a bottleneck.
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

// Records the maximum of the remaining divergence alone.
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
