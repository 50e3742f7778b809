// Colours of values; after STOPS are bound.
uniform int stopCount;
uniform float low, perRange;  // value of the first colour, and 1 / what the last one is above it

vec4 mappedColor(float value) {
  precise float share = (value - low) * perRange;
  precise float place = clamp(share, 0.0, 1.0) * float(stopCount - 1);
  int stop = int(floor(place));
  vec4 before = LOAD_INPUT(stops, stop), after = LOAD_INPUT(stops, min(stop + 1, stopCount - 1));
  precise vec4 color = before + (after - before) * (place - float(stop));
  return color;
}
