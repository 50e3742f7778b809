// Bounds of what casts shadows, as keys that order like the floats they stand for, so that integer atomics
// can reduce them: light space x, y, z (m), then x and z of the shadow on the ground (m).
#include "draw/frame_block.glsl"
const int boundCount = 5;
layout(std430, binding = boundsBinding) restrict buffer BoundsBlock {
  uint boundLow[boundCount];
  uint boundHigh[boundCount];
};

uint orderedKey(float x) {
  uint bits = floatBitsToUint(x);
  return bits ^ ((bits >> 31) != 0u ? 0xffffffffu : 0x80000000u);
}
float fromOrderedKey(uint key) {
  return uintBitsToFloat(key ^ ((key >> 31) != 0u ? 0x80000000u : 0xffffffffu));
}
// Low and grazing suns would throw shadows without end.
float sunHeight() {
  return max(frame.sunDirection.y, 0.05);
}
