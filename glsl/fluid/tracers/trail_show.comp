// Draws the streaks over the displayed field. One invocation per cell.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "fluid/tracers/tracer_types.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(shownBinding, ShownBlock, shown)
INPUT_WORDS(trailBinding, TrailBlock, trail)
uniform ivec2 size;
uniform vec3 color;
uniform float perUnit;  // Amount of light or ink per unit of a trail

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  if (x >= size.x || y >= size.y) return;
  int cell = y * size.x + x;
  uint level = LOAD_INPUT_WORDS(trail, cell >> 2)[cell & 3];
  int element = (y + 1) * (size.x + 2) + x + 1;
  vec4 under = LOAD_STATE(shown, element);
  precise float absorbed = float(int(level)) * -perUnit;
  float through = exactExp(absorbed);
  precise vec3 over = color + (under.xyz - color) * through;
  STORE_STATE(shown, element, vec4(over, under.w));
}
