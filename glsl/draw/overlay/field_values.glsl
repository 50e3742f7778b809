// Values and colours (linear RGB) of a field's cells. With `categories`, a value is the index of a colour; otherwise,
// the colours are spaced evenly over the range. Reads the uniforms of field_inputs.glsl. Compiles as GLSL and as C++.

FUNCTION uint wordAt(int i) {
  uvec4 four = texelFetch(words, i >> 2);
  return (i & 2) == 0 ? ((i & 1) == 0 ? four.x : four.y) : ((i & 1) == 0 ? four.z : four.w);
}

// Returns the float in `word` as a finite number. Magnitudes below 1e-20 become 0, other numbers are clamped to +-1e18,
// infinity becomes 1e18, and NaN or -infinity becomes -1e18.
FUNCTION float heldValue(uint word) {
  bool lost = (word & 0x7f800000u) == 0x7f800000u;
  float value = uintBitsToFloat(lost ? 0u : word);
  value = abs(value) < 1e-20f ? 0.0f : clamp(value, -1e18f, 1e18f);
  return lost ? (word == 0x7f800000u ? 1e18f : -1e18f) : value;
}

FUNCTION float valueOf(ivec2 cell) {
  int row = firstWord + cell.y * rowWords;
  if (cellKind == 0) return float(int(wordAt(row + (cell.x >> 5)) >> uint(cell.x & 31) & 1u));
  if (cellKind == 1) return float(int(wordAt(row + (cell.x >> 2)) >> uint(8 * (cell.x & 3)) & 255u));
  return heldValue(wordAt(row + cell.x * cellWords + (cellKind == 3 ? 3 : 0)));
}

// Returns the position of a value in the range: 0 for the first colour, 1 for the last.
FUNCTION float placeOf(float value) {
  ROUNDED float place = (value - rangeLow) * rangeFactor;
  return abs(place) < 1e-9f ? 0.0f : clamp(place, -1e9f, 1e9f);
}

FUNCTION vec3 stopAt(int i) {
  return vec3(texelFetch(stops, i));
}

FUNCTION vec3 colorAtPlace(float place) {
  ROUNDED float at = clamp(place, 0.0f, 1.0f) * float(stopCount - 1);
  int stop = int(at);
  ROUNDED float beyond = at - float(stop);
  return blend(stopAt(stop), stopAt(min(stop + 1, stopCount - 1)), beyond);
}

FUNCTION vec3 colorOf(float value) {
  if (!categories) return colorAtPlace(placeOf(value));
  ROUNDED float number = clamp(value, 0.0f, float(stopCount - 1)) + 0.5f;
  return stopAt(int(number));
}

// Returns the colour of a cell with the given value: the colour stored in the cell if there is one, else
// colorOf(value).
FUNCTION vec3 colorOfCell(ivec2 cell, float value) {
  if (cellKind != 3) return colorOf(value);
  int word = firstWord + cell.y * rowWords + cell.x * cellWords;
  return vec3(clamp(heldValue(wordAt(word)), 0.0f, 1e4f), clamp(heldValue(wordAt(word + 1)), 0.0f, 1e4f),
              clamp(heldValue(wordAt(word + 2)), 0.0f, 1e4f));
}
