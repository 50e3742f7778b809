// A translucent panel with rounded corners, axes, and curves as lines of even thickness over a faint fill.
// Everything is in the picture's own encoded colours; alpha is premultiplied.
#include "draw/bindings.glsl"
#include "draw/screen/film.glsl"
layout(binding = countUnit) uniform usamplerBuffer counts;
layout(binding = columnUnit) uniform sampler2D columns;  // chart_columns.comp
uniform vec4 panel;    // whole pixels: left, top, right, bottom
uniform vec4 plot;     // the same, of the curves
uniform float unit;    // pixels: thickness of a thin line
uniform int curves;
uniform vec3 colors[4];  // linear
uniform int steps;
uniform float end;     // pixels from the left of the plot to the last count
uniform float top;
layout(location = 0) out vec4 pixel;

vec4 over(vec4 below, vec3 color, float alpha) {
  return vec4(color * alpha, alpha) + below * (1.0 - alpha);
}

float distanceTo(vec2 p, vec2 a, vec2 b) {
  vec2 along = b - a;
  return length(p - a - along * clamp(dot(p - a, along) / max(dot(along, along), 1e-12), 0.0, 1.0));
}

/// Distances of a point of the plot (pixels from its top left) from the curves, and by how much it lies below them.
void look(vec2 p, vec2 size, float reach, out vec4 nearest, out vec4 below) {
  nearest = vec4(1e6);
  below = vec4(-1e6);
  int middle = int(floor(p.x));
  for (int c = max(middle - int(reach), 0); c <= min(middle + int(reach), int(size.x) - 1); ++c) {
    vec4 enter = texelFetch(columns, ivec2(c, 0), 0);
    if (enter.x < 0.0) break;
    float x1 = min(float(c + 1), max(end, float(c) + 1e-3));
    vec4 a = (1.0 - enter) * size.y, b = (1.0 - texelFetch(columns, ivec2(c, 1), 0)) * size.y;
    vec4 low = (1.0 - texelFetch(columns, ivec2(c, 2), 0)) * size.y;
    vec4 high = (1.0 - texelFetch(columns, ivec2(c, 3), 0)) * size.y;
    for (int k = 0; k < curves; ++k) {
      nearest[k] = min(nearest[k], distanceTo(p, vec2(float(c), a[k]), vec2(x1, b[k])));
      // What is more than a straight line within the column.
      if (high[k] < min(a[k], b[k]) - 0.01 || low[k] > max(a[k], b[k]) + 0.01)
        nearest[k] = min(nearest[k], distanceTo(p, vec2(float(c) + 0.5, high[k]), vec2(float(c) + 0.5, low[k])));
      if (c == middle && p.x <= end) below[k] = p.y - mix(a[k], b[k], p.x - float(c));
    }
  }
}

vec4 withCurves(vec4 sum, vec2 p, vec2 size) {
  float radius = 0.8 * unit;
  vec4 nearest, below;
  look(p, size, ceil(radius) + 1.0, nearest, below);
  uvec4 last = texelFetch(counts, steps - 1);
  bool within = all(greaterThanEqual(p, vec2(0.0))) && all(lessThanEqual(p, size));
  for (int k = 0; k < curves; ++k)
    if (within) sum = over(sum, encoded(colors[k]), 0.10 * clamp(below[k] + 0.5, 0.0, 1.0));
  for (int k = curves - 1; k >= 0; --k) {
    vec3 color = encoded(clamp(colors[k], 0.0, 1.0));
    float head = length(p - vec2(end, (1.0 - clamp(float(last[k]) / top, 0.0, 1.0)) * size.y));
    sum = over(sum, color, 0.25 * clamp(4.5 * unit + 0.5 - head, 0.0, 1.0));
    float line = min(nearest[k] - radius, head - 2.0 * unit);
    sum = over(sum, color, clamp(0.5 - line, 0.0, 1.0));
  }
  return sum;
}

void main() {
  vec2 at = gl_FragCoord.xy;
  vec2 size = panel.zw - panel.xy;
  float corner = 5.0 * unit;
  vec2 outside = abs(at - 0.5 * (panel.xy + panel.zw)) - 0.5 * size + corner;
  float edge = length(max(outside, 0.0)) + min(max(outside.x, outside.y), 0.0) - corner;
  float shape = clamp(0.5 - edge, 0.0, 1.0);
  vec4 sum = vec4(vec3(0.05, 0.06, 0.08) * 0.78, 0.78);
  sum = over(sum, vec3(1.0), 0.10 * clamp(0.5 + edge + unit, 0.0, 1.0));
  vec2 p = at - plot.xy, plotSize = plot.zw - plot.xy;
  if (p.x >= 0.0 && p.x <= plotSize.x && p.y >= -0.5 * unit && p.y <= plotSize.y) {
    float quarter = p.y / plotSize.y * 4.0;
    float toLine = abs(quarter - round(quarter)) * plotSize.y / 4.0;
    sum = over(sum, vec3(1.0), 0.09 * clamp(0.5 * unit + 0.5 - toLine, 0.0, 1.0));
  }
  bool axes = (p.x >= -unit && p.x < 0.0 && p.y >= 0.0 && p.y < plotSize.y + unit) ||
              (p.y >= plotSize.y && p.y < plotSize.y + unit && p.x >= -unit && p.x < plotSize.x);
  if (axes) sum = over(sum, vec3(1.0), 0.45);
  if (steps > 0) sum = withCurves(sum, p, plotSize);
  pixel = sum * shape;
}
