// Uniforms and textures of a chart, and its position in the picture.
#include "draw/bindings.glsl"
layout(binding = countUnit) uniform usamplerBuffer counts;
uniform int steps;     // number of steps counted so far
uniform float perTop;  // 1 / (count at the top of the plot)
layout(binding = columnUnit) uniform sampler2D columns;  // condensed curves, written by chart_columns.comp
uniform vec4 panel;      // bounds of the panel in whole pixels: left, top, right, bottom
uniform vec4 plot;       // bounds of the area with the curves in whole pixels: left, top, right, bottom
uniform float unit;      // thickness of a thin line in pixels
uniform int curves;
uniform vec3 colors[4];  // sRGB-encoded colour of each curve
uniform float zero;    // height of the baseline, as a fraction of the plot; the area between baseline and curve is
                       // filled
uniform float end;       // distance from the plot's left edge to the last count, in pixels

vec4 columnAt(int column, int row) {
  return texelFetch(columns, ivec2(column, row), 0);
}
