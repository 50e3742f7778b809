// Converts distances to a field of floats, in which cells that no wave has reached have the value -1. One invocation
// per cell.
#include "cave/wave.glsl"
layout(std430, binding = labelsBinding) restrict writeonly buffer ShownBlock { float shown[]; };

void main() {
  if (gl_GlobalInvocationID.x >= 32u * uint(rowWords)) return;
  uint cell = numberOf(int(gl_GlobalInvocationID.x), int(gl_GlobalInvocationID.y));
  shown[cell] = distances[cell] == nowhere ? -1.0 : float(distances[cell]);
}
