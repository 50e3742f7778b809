// Reduces the steps of a chart's curves to columns of pixels. The arithmetic is exact for both rasterizers. One
// invocation writes one column.
#define EXACT_PICTURE
#include "draw/arithmetic.glsl"
#include "draw/overlay/chart_inputs.glsl"
#include "draw/overlay/chart_columns.glsl"
layout(local_size_x = 64) in;
layout(rgba32f, binding = targetImage) writeonly uniform restrict image2D condensed;
uniform int columnCount;
uniform float perColumn;  // number of steps per column of pixels

void main() {
  int number = int(gl_GlobalInvocationID.x);
  if (number >= columnCount) return;
  ChartColumn column = columnOf(number, perColumn);
  imageStore(condensed, ivec2(number, 0), column.enter);
  imageStore(condensed, ivec2(number, 1), column.leave);
  imageStore(condensed, ivec2(number, 2), column.lowest);
  imageStore(condensed, ivec2(number, 3), column.highest);
}
