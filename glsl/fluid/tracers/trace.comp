// Moves tracers by one substep and draws their paths. If FIRST is defined, initializes the tracers instead. One
// invocation per tracer.
#include "fluid/tracers/tracers.glsl"
layout(std430, binding = trailBinding) restrict buffer TrailBlock { uint trail[]; };

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
#ifdef FIRST
  STORE_STATE(tracers, i, tracerFirst(i));
#else
  TracerMove m = tracerMoved(i, LOAD_STATE(tracers, i));
  STORE_STATE(tracers, i, m.next);
  if (!m.draws) return;
  float length_ = tracerLength(m.from, m.to);
  int points = tracerPoints(length_);
  for (int k = 0; k < points; ++k)
    for (int corner = 0; corner < 4; ++corner) {
      ivec3 mark = tracerMark(m.from, m.to, length_, points, k, corner);
      bool inside = mark.x >= 0 && mark.y >= 0 && mark.x < windGrid.size.x && mark.y < windGrid.size.y;
      if (inside && mark.z > 0) atomicAdd(trail[mark.y * windGrid.size.x + mark.x], uint(mark.z));
    }
#endif
}
