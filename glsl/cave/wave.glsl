// Breadth-first waves over the open cells, over edges. The cells of a wave stand together in the queue, in any order.
#include "cave/cells.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = distancesBinding) coherent restrict buffer DistanceBlock { uint distances[]; };
layout(std430, binding = queueBinding) coherent restrict buffer QueueBlock { uint queue[]; };
layout(std430, binding = flagsBinding) coherent restrict buffer WaveBlock {
  uint begin, end;  // of the present wave in the queue
  uint steps;       // of its cells from the start
  uint farthest;    // the lowest cell of the last wave, when there are no more
  uint tail;        // of the queue
  uint over;        // not 0: the last wave was there
} wave;
