// Solves stretch and shear of the faces of one colour. These faces have no vertex in common, so all of them can move
// their corners simultaneously. One invocation per face.
#include "garment/kernel.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(elementsBinding, ElementBlock, elements)
INPUT_WORDS(cornersBinding, CornerBlock, corners)
#if DAMPED
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
#endif
STATE_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
uniform int first;  // Index of the colour's first face
#include "garment/membrane.glsl"

void main() {
  int k = int(gl_GlobalInvocationID.x);
  if (k >= count) return;
  int i = first + k;
  uvec4 face = LOAD_INPUT_WORDS(corners, i);
  vec4 a = LOAD_ONCE(nextPositions, int(face.x));
  vec4 b = LOAD_ONCE(nextPositions, int(face.y));
  vec4 c = LOAD_ONCE(nextPositions, int(face.z));
  precise vec3 compliance = LOAD_INPUT(elements, 2 * i + 1).xyz * stepData.complianceScale;
  vec4 shape = LOAD_INPUT(elements, 2 * i);
  vec3 kept = vec3(0.0f);
#if DAMPED
  kept = keptStrain(LOAD_INPUT(positions, int(face.x)).xyz, LOAD_INPUT(positions, int(face.y)).xyz,
                    LOAD_INPUT(positions, int(face.z)).xyz, shape);
#endif
  FaceShift shift = faceShift(a, b, c, shape, compliance, kept);
  STORE_STATE(nextPositions, int(face.x), shifted(a, shift.a));
  STORE_STATE(nextPositions, int(face.y), shifted(b, shift.b));
  STORE_STATE(nextPositions, int(face.z), shifted(c, shift.c));
}
