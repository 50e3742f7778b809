// Runs several waves in one workgroup, because a wave has few cells and a separate dispatch for each would cost more.
#include "cave/wave.glsl"
uniform int waves;
shared uint first, last, step_;
shared bool ended;

void visit(int x, int y, uint step) {
  if (!isOpen(x, y)) return;
  uint cell = numberOf(x, y);
  if (atomicCompSwap(distances[cell], nowhere, step) == nowhere) queue[atomicAdd(wave.tail, 1u)] = cell;
}

void share() {
  if (gl_LocalInvocationIndex == 0u) {
    first = wave.begin;
    last = wave.end;
    step_ = wave.steps;
    ended = wave.over != 0u || first == last;
  }
  memoryBarrierShared();
  barrier();
}

void finishWave() {
  memoryBarrierBuffer();
  barrier();
  bool more = wave.tail != last;
  if (!more)
    for (uint i = first + gl_LocalInvocationIndex; i < last; i += gl_WorkGroupSize.x) atomicMin(wave.farthest, queue[i]);
  memoryBarrierBuffer();
  barrier();
  if (gl_LocalInvocationIndex == 0u) {
    if (more) {
      wave.begin = last;
      wave.end = wave.tail;
      wave.steps = step_ + 1u;
    } else {
      wave.over = 1u;
    }
  }
  memoryBarrierBuffer();
  barrier();
}

void main() {
  for (int i = 0; i < waves; ++i) {
    share();
    if (ended) return;
    for (uint at = first + gl_LocalInvocationIndex; at < last; at += gl_WorkGroupSize.x) {
      ivec2 cell = placeOf(queue[at]);
      visit(cell.x - 1, cell.y, step_ + 1u);
      visit(cell.x + 1, cell.y, step_ + 1u);
      visit(cell.x, cell.y - 1, step_ + 1u);
      visit(cell.x, cell.y + 1, step_ + 1u);
    }
    finishWave();
  }
}
