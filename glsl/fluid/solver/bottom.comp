// Solves the coarsest level, which has at most 64 cells, by overrelaxed red-black sweeps (SOR). One workgroup, one
// invocation per cell.
#include "fluid/solver/levels.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = raisedOutBinding) writeonly buffer RaisedOutBlock { float raisedOut[]; };
shared float values[64];

float valueAt(ivec2 place) {
  ivec2 c = within(place);
  return isInside(c) ? values[c.y * level.cells.x + c.x] : 0.0;
}

void main() {
  int i = int(gl_LocalInvocationIndex);
  bool used = i < level.cells.x * level.cells.y;
  ivec2 c = ivec2(i % level.cells.x, i / level.cells.x);
  float rhs = used ? inPool(level.rhs, c) : 0.0;
  vec4 w = used ? weightsOf(c) : vec4(0.0);
  float diag = diagonal(w);
  values[i] = 0.0;
  barrier();
  for (int half_ = 0; half_ < 2 * bottomSweeps; ++half_) {
    float here = values[i];
    float sum = neighbours(w, valueAt(c - ivec2(1, 0)), valueAt(c + ivec2(1, 0)), valueAt(c - ivec2(0, 1)),
                           valueAt(c + ivec2(0, 1)));
    float next = (c.x + c.y + half_ & 1) == 0 ? overrelaxed(here, relaxed(rhs, sum, diag)) : here;
    barrier();
    values[i] = next;
    barrier();
  }
  if (used) raisedOut[4 * (level.up + blockOf(c)) + 2 * (c.y & 1) + (c.x & 1)] = values[i];
}
