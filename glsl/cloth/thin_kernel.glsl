// Part common to the thin-collider kernels for grids and meshes: loads a vertex's previous position, current position
// and velocity, and stores its displacement.
#include "cloth/motion.glsl"
#include "collide/closest.glsl"
#include "cloth/thin.glsl"
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
INPUT_ARRAY(nextPositionsBinding, NextBlock, nextPositions)
INPUT_ARRAY(velocitiesBinding, VelocityBlock, velocities)
STATE_ARRAY(shiftsBinding, ShiftBlock, shifts)

Corner loadCorner(int i) {
  return cornerOf(LOAD_INPUT(positions, i), LOAD_INPUT(nextPositions, i), LOAD_INPUT(velocities, i));
}

void leaveShift(int i, ThinPush sum) {
  STORE_STATE(shifts, 2 * i, vec4(sum.shift, 0.0f));
  STORE_STATE(shifts, 2 * i + 1, vec4(sum.change, 0.0f));
}
