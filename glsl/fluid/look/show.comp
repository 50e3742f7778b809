// Computes the displayed field of a fluid: colour in rgb, value in a. One invocation per cell.
#define READS_DYE
#include "fluid/grid.glsl"
#include "fluid/look/look.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(nextFlowBinding, NextBlock, shown)
INPUT_ARRAY(carriedBinding, StopBlock, stops)  // Colour stops of the colour map
uniform float brightness;     // Factor on the dye
uniform vec3 paper;           // Background colour where there is no dye
uniform vec3 obstacleColor;
#include "common/color_map.glsl"

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  if (x >= size.x || y >= size.y) return;
  float open = openPart(x, y);
  float value = open == 0.0 ? 0.0 : shownValue(SHOWN, x, y);
  vec4 fluid = SHOWN == dyeShown ? shownColor(LOOK, brightness, dyeAt(x, y), flowAt(x, y).z, paper) : mappedColor(value);
  precise vec4 color = vec4(obstacleColor, 0.0) + (fluid - vec4(obstacleColor, 0.0)) * open;
  STORE_STATE(shown, elementOf(x, y), vec4(color.xyz, value));
}
