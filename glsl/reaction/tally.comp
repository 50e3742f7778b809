// Measures a rule's species once per frame. n is the number of species, at most four. Sum i is the sum of species i % n
// to the power i / n + 1. Maximum i is the maximum of species i.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "reaction/bindings.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(stageBinding, CellBlock, cells)
uniform ivec2 size;
uniform int columns, species;

struct Tallied {
  vec4 sums;
  vec4 maximum;
};

Tallied tallied(int i) {
  int y = i / size.x, x = i - y * size.x;
  Tallied t;
  t.maximum = vec4(-1e30f);
  for (int k = 0; k < species; ++k) t.maximum[k] = LOAD_INPUT(cells, (k * size.y + y) * columns + (x >> 2))[x & 3];
  for (int k = 0; k < 4; ++k) {
    float value = t.maximum[k % species];
    t.sums[k] = value;
    for (int power = k / species; power > 0; --power) {
      precise float product = t.sums[k] * value;
      t.sums[k] = exactFlush(product);
    }
  }
  return t;
}
#include "grid/tally.glsl"

void main() {
  int lane = int(gl_GlobalInvocationID.x);
  if (lane < tallyLanes) tallyLane(lane, size.x * size.y);
}
