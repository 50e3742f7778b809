// What is drawn of a fluid: colour in rgb, a value in a.
#define READS_DYE
#include "fluid/grid.glsl"
#include "fluid/look.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(nextFlowBinding, NextBlock, shown)
INPUT_ARRAY(carriedBinding, StopBlock, stops)  // of the colour map
uniform int stopCount;
uniform float low, perRange;  // value of the first colour, and 1 / what the last one is above it
uniform float brightness;     // of dye
uniform vec3 obstacleColor;

vec4 mappedColor(float value) {
  precise float share = (value - low) * perRange;
  precise float place = clamp(share, 0.0, 1.0) * float(stopCount - 1);
  int stop = int(floor(place));
  vec4 before = LOAD_INPUT(stops, stop), after = LOAD_INPUT(stops, min(stop + 1, stopCount - 1));
  precise vec4 color = before + (after - before) * (place - float(stop));
  return color;
}

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  if (x >= size.x || y >= size.y) return;
  float open = openPart(x, y);
  float value = open == 0.0 ? 0.0 : shownValue(SHOWN, x, y);
  vec4 fluid = SHOWN == dyeShown ? shownColor(INK == 1, brightness, dyeAt(x, y)) : mappedColor(value);
  precise vec4 color = vec4(obstacleColor, 0.0) + (fluid - vec4(obstacleColor, 0.0)) * open;
  STORE_STATE(shown, elementOf(x, y), vec4(color.xyz, value));
}
