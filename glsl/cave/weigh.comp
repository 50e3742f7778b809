// Finds the shortest connection of each tree to another tree. Pass 0 finds the length. Pass 1 finds, among the
// connections of this length, the one with the lowest edge index.
#include "cave/ways.glsl"
layout(local_size_x = 64) in;
uniform int pass;

void weigh(ivec2 at, uint from, int tree, ivec2 next, uint edge) {
  if (next.x >= size.x || next.y >= size.y) return;
  uint to = sources[numberOf(next.x, next.y)];
  int other = int(trees[labels[runOf(to)]]);
  if (other == tree) return;
  ivec2 before = abs(placeOf(from) - at), after = abs(placeOf(to) - next);
  uint steps = uint(before.x + before.y + after.x + after.y + 1);
  if (pass == 0) {
    atomicMin(weights[tree], steps);
    atomicMin(weights[other], steps);
  } else {
    if (weights[tree] == steps) atomicMin(edges[tree], edge);
    if (weights[other] == steps) atomicMin(edges[other], edge);
  }
}

void main() {
  if (gl_GlobalInvocationID.x >= 32u * uint(rowWords)) return;
  uint cell = numberOf(int(gl_GlobalInvocationID.x), int(gl_GlobalInvocationID.y));
  ivec2 at = placeOf(cell);
  if (at.x >= size.x) return;
  uint from = sources[cell];
  int tree = int(trees[labels[runOf(from)]]);
  weigh(at, from, tree, at + ivec2(1, 0), 2u * cell);
  weigh(at, from, tree, at + ivec2(0, 1), 2u * cell + 1u);
}
