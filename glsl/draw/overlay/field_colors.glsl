// Colours of a field's values, linear RGB. CATEGORIES: a value is the number of its colour; else colours
// lie evenly over `range`.
layout(binding = colorUnit) uniform samplerBuffer stops;
uniform int stopCount;
uniform vec2 range;

/// 0 at the first colour, 1 at the last.
float placeOf(float value) {
  return (value - range.x) / (range.y - range.x);
}

vec3 colorAtPlace(float place) {
  float at = (place > 0.0 ? min(place, 1.0) : 0.0) * float(stopCount - 1);  // NaN: the first colour
  int stop = int(at);
  return mix(texelFetch(stops, stop).rgb, texelFetch(stops, min(stop + 1, stopCount - 1)).rgb,
             at - float(stop));
}

vec3 colorOf(float value) {
#ifdef CATEGORIES
  return texelFetch(stops, clamp(int(value + 0.5), 0, stopCount - 1)).rgb;
#else
  return colorAtPlace(placeOf(value));
#endif
}
