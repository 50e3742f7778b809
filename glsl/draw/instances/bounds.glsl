// Bounds of the shadow casters, as ordered keys: x, y, z in light space (m), then x and z of the casters' shadows on
// the ground (m).
#include "common/exact.glsl"
#include "draw/frame_block.glsl"
#include "draw/ordered_key.glsl"
const int boundCount = 5;
layout(std430, binding = boundsBinding) restrict buffer BoundsBlock {
  uint boundLow[boundCount];
  uint boundHigh[boundCount];
};

// Returns the sine of the sun's elevation, at least 0.05, because a sun at or below the horizon would cast endless
// shadows.
float sunHeight() {
  return max(frame.sunDirection.y, 0.05);
}
