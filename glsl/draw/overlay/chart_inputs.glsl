// What a shader gets of a chart and of its place on the picture.
#include "draw/bindings.glsl"
layout(binding = countUnit) uniform usamplerBuffer counts;
uniform int steps;     // counted so far
uniform float perTop;  // 1 / the count at the top of the plot
layout(binding = columnUnit) uniform sampler2D columns;  // chart_columns.comp
uniform vec4 panel;      // whole pixels: left, top, right, bottom
uniform vec4 plot;       // the same, of the curves
uniform float unit;      // pixels: thickness of a thin line
uniform int curves;
uniform vec3 colors[4];  // encoded
uniform float zero;    // part of the height towards which curves are filled
uniform float end;       // pixels from the left of the plot to the last count

vec4 columnAt(int column, int row) {
  return texelFetch(columns, ivec2(column, row), 0);
}
