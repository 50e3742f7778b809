// What the curves of a chart are in each column of pixels, as fractions of its height: where they enter it, where
// they leave it, the lowest and the highest in it. Where nothing is counted yet: -1. So the cost of drawing does
// not grow with the number of steps.
#include "draw/bindings.glsl"
layout(local_size_x = 64) in;
layout(binding = countUnit) uniform usamplerBuffer counts;
layout(rgba32f, binding = targetImage) writeonly uniform restrict image2D columns;
uniform int columnCount;
uniform int steps;     // counted so far
uniform float perColumn;  // steps
uniform float top;
const int maxLooked = 16384;  // at, a column: above it some steps are passed over

vec4 at(float place) {
  int step = clamp(int(place), 0, steps - 1);
  vec4 low = vec4(texelFetch(counts, step)), high = vec4(texelFetch(counts, min(step + 1, steps - 1)));
  return clamp(mix(low, high, clamp(place - float(step), 0.0, 1.0)) / top, 0.0, 1.0);
}

void main() {
  int column = int(gl_GlobalInvocationID.x);
  if (column >= columnCount) return;
  float first = float(column) * perColumn, end = min(float(column + 1) * perColumn, float(steps - 1));
  vec4 enter = vec4(-1.0), leave = vec4(-1.0), lowest = vec4(-1.0), highest = vec4(-1.0);
  if (first <= float(steps - 1)) {
    enter = at(first);
    leave = at(end);
    lowest = min(enter, leave);
    highest = max(enter, leave);
    int last = int(ceil(end)) - 1, stride = max(1, (last - int(first)) / maxLooked);
    for (int step = int(first) + 1; step <= last; step += stride) {
      vec4 here = clamp(vec4(texelFetch(counts, step)) / top, 0.0, 1.0);
      lowest = min(lowest, here);
      highest = max(highest, here);
    }
  }
  imageStore(columns, ivec2(column, 0), enter);
  imageStore(columns, ivec2(column, 1), leave);
  imageStore(columns, ivec2(column, 2), lowest);
  imageStore(columns, ivec2(column, 3), highest);
}
