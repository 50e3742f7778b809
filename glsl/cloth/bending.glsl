// Bending of a fabric by the plate energy of second differences. The energy is quadratic in the positions, so the force
// is linear in the positions and independent of the cloth's orientation. E = 1/2 (D / L^2) sum of (|Dxx|^2 + |Dyy|^2)
// over nodes + D / L^2 sum of |Dxy|^2 over cells, with the bending stiffness D and the spacing L. Borders are free: a
// difference that extends beyond the grid has no energy, and differences along a border have the weight 1/2. A clamped
// border has a ghost node outside, x[-1] = x[1] - 2 t, where t is the rest vector from the border node to its inner
// neighbour.
FUNCTION vec3 loadPoint(ivec2 at, int dx, int dy) {
  return vec3(loadPosition(neighbour(at, dx, dy)));
}
// Returns the energy gradient dE/dx of the second differences along a row or a column that are centred on the previous
// node, this node and the next node.
FUNCTION vec3 bendAlong(ivec2 at, vec3 here, bool row) {
  int dx = row ? 1 : 0, dy = row ? 0 : 1;
  int k = row ? at.x : at.y, count = row ? size.x : size.y;
  vec4 before = loadPosition(neighbour(at, -dx, -dy)), after = loadPosition(neighbour(at, dx, dy));
  vec4 low = stepData.clamped[row ? 0 : 2], high = stepData.clamped[row ? 1 : 3];
  precise vec3 first = loadPoint(at, -2 * dx, -2 * dy) - 2.0f * vec3(before) + here;
  precise vec3 middle = vec3(before) - 2.0f * here + vec3(after);
  precise vec3 last = here - 2.0f * vec3(after) + loadPoint(at, 2 * dx, 2 * dy);
  precise vec3 ghostFirst = 2.0f * (here - vec3(before) - vec3(low));
  precise vec3 ghostLast = 2.0f * (here - vec3(after) - vec3(high));
  bool heldFirst = k == 1 && low.w > 0.0f && before.w == 0.0f;
  bool heldLast = k == count - 2 && high.w > 0.0f && after.w == 0.0f;
  first = k >= 2 ? first : heldFirst ? ghostFirst : vec3(0.0f);
  middle = k >= 1 && k < count - 1 ? middle : vec3(0.0f);
  last = k < count - 2 ? last : heldLast ? ghostLast : vec3(0.0f);
  int other = row ? at.y : at.x, others = row ? size.y : size.x;
  float area = other == 0 || other == others - 1 ? 0.5f : 1.0f;
  precise vec3 gradient = (first - 2.0f * middle + last) * area;
  return gradient;
}
// Returns here - a - b + c for the cell in direction (dx, dy), where a, b and c are the cell's other corners, or zero
// if the cell is outside the grid. The gradient of the cell's energy is twice this value.
FUNCTION vec3 twist(ivec2 at, vec3 here, int dx, int dy) {
  bool there = at.x + dx >= 0 && at.y + dy >= 0 && at.x + dx < size.x && at.y + dy < size.y;
  precise vec3 cell = here - loadPoint(at, dx, 0) - loadPoint(at, 0, dy) + loadPoint(at, dx, dy);
  return there ? cell : vec3(0.0f);
}
FUNCTION vec3 bendingForce(ivec2 at, vec3 here) {
  precise vec3 twists = twist(at, here, -1, -1) + twist(at, here, 1, -1) + twist(at, here, -1, 1) + twist(at, here, 1, 1);
  precise vec3 gradient = bendAlong(at, here, true) + bendAlong(at, here, false) + 2.0f * twists;
  precise vec3 force = gradient * -stepData.perBend;
  return force;
}
