// Marching cubes (Lorensen and Cline 1987) on samples that are inside (at or above the level) or outside. A surface
// point is where the linear interpolation along an edge equals the level; its normal is the gradient there. The corners
// of a cube are numbered x + 2 y + 4 z, and the edges 4 axis + the index of their start in the other two axes. Compiles
// as GLSL and as C++.

// Returns the change of a value along an axis over two cells. At a border, the difference over one cell is doubled.
FUNCTION float volumeSlope(float before, float after, bool atBorder) {
  precise float rise = after - before;
  precise float twice = rise + rise;
  return atBorder ? twice : rise;
}

// Returns the outward unit normal, opposite to the gradient, which is interpolated between the edge's ends. If there is
// no gradient, returns `along`, the direction along the edge from inside to outside.
FUNCTION vec3 volumeNormal(vec3 first, vec3 second, float part, vec3 along) {
  precise vec3 slope = first + (second - first) * part;
  precise float square = slope.x * slope.x + slope.y * slope.y + slope.z * slope.z;
  bool flat_ = !(square >= 1e-20f && square <= 1e30f);
  precise vec3 unit = slope * -exactInverseSqrt(flat_ ? 1.0f : square);
  return flat_ ? along : unit;
}

FUNCTION vec3 volumePlace(vec3 corner, float spacing, vec3 cell) {
  precise vec3 place = corner + cell * spacing;
  return place;
}

// Returns the colour index for a value interpolated at the fraction `part` between `first` and `second`.
FUNCTION int volumeColor(float first, float second, float part, float low, float perRange) {
  precise float value = first + (second - first) * part;
  precise float share = (value - low) * perRange;
  precise float number = clamp(share, 0.0f, 1.0f) * 1023.0f + 0.5f;
  return int(number);
}
