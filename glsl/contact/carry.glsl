// Accumulates the displacements by which solids carry vertices. Needs the `tallies` array.

// Records the displacement `by` of vertex v. The maximum is taken separately for each axis and sign, so the order of
// invocations does not matter.
void carry(int v, vec3 by) {
  int up = upSection * contactStep.vertices + v, down = downSection * contactStep.vertices + v;
  for (int axis = 0; axis < 3; ++axis) {
    precise float other = -by[axis];
    if (by[axis] > 0.0f) atomicMax(tallies[up][axis], floatBitsToInt(by[axis]));
    if (by[axis] < 0.0f) atomicMax(tallies[down][axis], floatBitsToInt(other));
  }
}
void carryAll(ivec4 corners, vec4 carries, vec3 way) {
  for (int k = 0; k < 4; ++k) {
    if (carries[k] == 0.0f) continue;
    precise vec3 by = way * carries[k];
    carry(corners[k], by);
  }
}
