// Contour points on an edge between two samples.

// Returns the change of the field along the edge (x) and perpendicular to it (y), from the six cells around the edge.
// Across the edge, the differences are weighted 1, 2, 1, so that walls of binary fields also have smooth normals.
vec2 slopeAt(ivec2 cell, ivec2 along, float from, float to) {
  ivec2 side = along.yx;
  float fromBefore = valueAt(cell - side), fromAfter = valueAt(cell + side);
  float toBefore = valueAt(cell + along - side), toAfter = valueAt(cell + along + side);
  precise float rise = 2.0 * (to - from) + (toBefore - fromBefore) + (toAfter - fromAfter);
  precise float turn = (fromAfter - fromBefore) + (toAfter - toBefore);
  return vec2(rise, turn);
}

// Returns the outward unit vector (x, z), which points from high to low.
vec2 outward(ivec2 along, vec2 slope, bool rises) {
  precise float square = slope.x * slope.x + slope.y * slope.y;
  // If the square of the slope would be too small or too large, the direction of the edge is used.
  bool flat_ = square < 1e-20 || square > 1e30;
  float straight = rises ? -1.0 : 1.0;
  precise vec2 unit = slope * -exactInverseSqrt(flat_ ? 1.0 : square);
  vec2 across = flat_ ? vec2(straight, 0.0) : unit;
  return along.x != 0 ? across : across.yx;
}

void putVertex(uint vertex, vec2 place, float height, int color, vec3 normal) {
  positions[vertex] = vec4(place.x, height, place.y, float(color));
  normals[vertex] = vec4(normal, 0.0);
}

// Writes the four vertices of a point on the edge that begins at sample `at`. `rises` is true if the field rises
// towards the edge's end.
void putPoint(uint point, ivec2 at, ivec2 along, int level, bool rises) {
  ivec2 cell = at - 1, next = cell + along;  // Cells of the field
  bool within = cell.x >= 0 && cell.y >= 0 && next.x < fieldSize.x && next.y < fieldSize.y;
  within = within && cell.x < fieldSize.x && cell.y < fieldSize.y && next.x >= 0 && next.y >= 0;
  float part = 0.5;
  vec2 slope = vec2(0);
  if (within) {
    float first = valueAt(cell), second = valueAt(next);
    slope = slopeAt(cell, along, first, second);
    part = crossingPlace(first, second, levels[LEVELS == 1 ? 0 : level - 1]);
  }
  vec2 outwards = outward(along, slope, rises);
  precise vec2 sample_ = vec2(at) + vec2(along) * part;
  vec2 place = placeAt(sample_);
  float bottom = heights[LEVELS == 1 ? 0 : level - 1], top = heights[LEVELS == 1 ? 1 : level];
  vec3 normal = vec3(outwards.x, 0.0, outwards.y);
  uint vertex = firstPoint + 4u * point;
  int color = classColors * level;
  putVertex(vertex + rimBelow, place, bottom, color - classColors + footColor, vec3(0, 1, 0));
  putVertex(vertex + wallBottom, place, bottom, color + wallFootColor, normal);
  putVertex(vertex + wallTop, place, top, color + wallTopColor, normal);
#ifdef CEILING
  putVertex(vertex + rimAbove, place, top, color + footColor, vec3(0, -1, 0));
#else
  putVertex(vertex + rimAbove, place, top, color + edgeColor, vec3(0, 1, 0));
#endif
}
