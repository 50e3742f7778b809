// Bounds of what casts shadows, as ordered keys: light space x, y, z (m), then x and z of the shadow on the ground (m).
#include "common/exact.glsl"
#include "draw/frame_block.glsl"
#include "draw/ordered_key.glsl"
const int boundCount = 5;
layout(std430, binding = boundsBinding) restrict buffer BoundsBlock {
  uint boundLow[boundCount];
  uint boundHigh[boundCount];
};

// Low and grazing suns would throw shadows without end.
float sunHeight() {
  return max(frame.sunDirection.y, 0.05);
}
