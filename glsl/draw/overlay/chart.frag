// Draws a chart as a fragment shader (chart_shading.glsl).
#include "draw/arithmetic.glsl"
#include "draw/overlay/chart_inputs.glsl"
#include "draw/overlay/chart_columns.glsl"
#include "draw/overlay/chart_shading.glsl"
layout(location = 0) out vec4 pixel;

void main() {
  pixel = chartPixel(gl_FragCoord.xy);
}
