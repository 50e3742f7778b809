// Lookup in a colour map. Include after `stops` is declared.
uniform int stopCount;
uniform float low, perRange;  // Value of the first colour, and 1 / (value of the last colour - value of the first
                              // colour)

vec4 mappedColor(float value) {
  precise float share = (value - low) * perRange;
  precise float place = clamp(share, 0.0f, 1.0f) * float(stopCount - 1);
  int stop = int(floor(place));
  vec4 before = LOAD_INPUT(stops, stop), after = LOAD_INPUT(stops, min(stop + 1, stopCount - 1));
  precise vec4 color = before + (after - before) * (place - float(stop));
  return color;
}
