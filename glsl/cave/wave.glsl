// Breadth-first waves over the open cells, which are connected over edges. In the queue, the cells of a wave are
// contiguous, in any order.
#include "cave/cells.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = distancesBinding) coherent restrict buffer DistanceBlock { uint distances[]; };
layout(std430, binding = queueBinding) coherent restrict buffer QueueBlock { uint queue[]; };
layout(std430, binding = flagsBinding) coherent restrict buffer WaveBlock {
  uint begin, end;  // Range of the current wave in the queue
  uint steps;       // Distance of the current wave's cells from the start
  uint farthest;    // Lowest cell of the last wave
  uint tail;        // End of the queue
  uint over;        // Nonzero if the last wave is finished
} wave;
