// Reduces a chart's curves to columns of pixels, so that the cost of drawing does not grow with the number of steps.
// For each curve, a column stores the height at its left edge, the height at its right edge, the min and the max, as
// fractions of the plot's height. The values are -1 if the column has no steps yet. Compiles as GLSL and as C++, after
// chart_inputs.glsl.
const int maxLooked = 16384;  // max number of steps that are read per column; if there are more, some are skipped

struct ChartColumn {
  vec4 enter;
  vec4 leave;
  vec4 lowest;
  vec4 highest;
};

// Converts a count to float with a single rounding to nearest, because drivers may round conversions of more than 24
// bits differently.
FUNCTION float countOf(uint n) {
  ROUNDED float count = float(int(n >> 12u)) * 4096.0f + float(int(n & 4095u));
  return count;
}

// Returns the counts of a step as fractions of the plot's height.
FUNCTION vec4 heightsOf(uvec4 n) {
  ROUNDED vec4 heights = vec4(countOf(n.x), countOf(n.y), countOf(n.z), countOf(n.w)) * perTop;
  return clamp(heights, 0.0f, 1.0f);
}

// Returns the heights at a fractional step, interpolated linearly between two steps.
FUNCTION vec4 heightsAt(float place) {
  int number = clamp(int(place), 0, steps - 1);
  vec4 low = heightsOf(texelFetch(counts, number)), high = heightsOf(texelFetch(counts, min(number + 1, steps - 1)));
  ROUNDED float beyond = place - float(number);
  ROUNDED vec4 heights = low + (high - low) * clamp(beyond, 0.0f, 1.0f);
  return heights;
}

// Returns column number `column` of a chart with `stepsEach` steps per column.
FUNCTION ChartColumn columnOf(int column, float stepsEach) {
  ROUNDED float first = float(column) * stepsEach;
  ROUNDED float next = float(column + 1) * stepsEach;
  float stop = min(next, float(steps - 1));
  ChartColumn found;
  found.enter = found.leave = found.lowest = found.highest = vec4(-1.0f);
  if (first > float(steps - 1)) return found;
  found.enter = heightsAt(first);
  found.leave = heightsAt(stop);
  vec4 lowest = min(found.enter, found.leave), highest = max(found.enter, found.leave);
  int last = int(ceil(stop)) - 1, stride = max(1, (last - int(first)) / maxLooked);
  for (int i = int(first) + 1; i <= last; i += stride) {
    vec4 here = heightsOf(texelFetch(counts, i));
    lowest = min(lowest, here);
    highest = max(highest, here);
  }
  found.lowest = lowest;
  found.highest = highest;
  return found;
}
