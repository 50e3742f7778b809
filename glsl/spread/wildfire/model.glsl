// Fire that spreads between neighbouring cells. Compiles as GLSL and, inside a struct with `stepData` (WildfireStep)
// and climbFactor(int), as C++, after gale.glsl.

// Returns the chance t that a neighbour ignites a cell, multiplied by e^(slope * tangent), where the tangent is the
// rise of the ground along the path, and limited to 65536. An incline holds the rises to the right and downwards in
// units of 1/16 cell per cell; 128 is added to each, and each has eight bits. climbFactor(i), which the including file
// provides, is e^(slope (i - 128) / 16) for i below 256. The next 256 values are the same with the rise divided by
// sqrt(2), because a diagonal neighbour is sqrt(2) away and offset along both axes.
FUNCTION uint climbed(uint t, uint d, uint incline) {
  uint place = d + (d >> 2u);  // Index in the 3x3 neighbourhood
  int x = int(place % 3u) - 1;
  int y = int(place / 3u) - 1;
  int across = -x * (int(incline & 255u) - 128);
  int down = -y * (int(incline >> 8u) - 128);
  precise float chance = float(int(t));
  if (x == 0 || y == 0) {
    chance = chance * climbFactor(128 + across + down);
  } else {
    chance = chance * climbFactor(384 + across) * climbFactor(384 + down);
  }
  return uint(int(min(chance, 65536.0f)));
}

// Returns the chance in units of 1/65536 that a cell is ignited by its burning neighbours (a bit mask in the order of
// WildfireStep.spread). The fuel (0 to 256) is a weight of each chance t. Chances are combined as p + t (1 - p), in
// integers.
FUNCTION uint catchChance(uint burning, uint fuel, uint incline, uint gale) {
  uint p = 0u;
  for (uint d = 0u; d < 8u; ++d) {
    uint t = (burning >> d & 1u) != 0u ? stepData.spread[d >> 2u][d & 3u] : 0u;
    if (incline != evenGround) t = climbed(t, d, incline);
    if (gale != stillAir) t = blownOver(t, d, gale);
    t = (t * fuel) >> 8u;
    p = t + (((p - (p >> 16u)) * (65536u - t)) >> 16u);
  }
  return p;
}

// Maps fuel bytes from 0 to 255 to weights from 0 to 256, so that full fuel has the weight 1 (256/256).
FUNCTION uint fuelWeight(uint level) {
  return level + (level >> 7u);
}

// Returns the maximum flight of an ember onto a cell with this gale, in units of 1/256 cell, clamped to the range of
// emberFlight().
FUNCTION ivec2 galeFlight(uint gale) {
  ivec2 parts = galeParts(gale);
  precise float x = float(parts.x) * stepData.emberReach;
  precise float y = float(parts.y) * stepData.emberReach;
  return ivec2(int(clamp(x, -512000.0f, 512000.0f)), int(clamp(y, -512000.0f, 512000.0f)));
}

// Returns the random displacement, in cells, of an ember from its source to the cell where it lands: along the wind up
// to `longest` (vector, in units of 1/256 cell), with a sideways deviation.
FUNCTION ivec2 emberFlight(uvec3 random, ivec2 longest) {
  int along = int(random.y >> 20u);            // Position along the flight, 0 to 4095
  int side = int(random.z >> 20u) - 2048;      // Sideways position, -2048 to 2047
  int aside = (stepData.emberSpread * side) >> 11;  // Sideways displacement, in units of 1/256 of the flight
  int dx = (longest.x * along) >> 12;
  int dy = (longest.y * along) >> 12;
  return ivec2((dx - ((dy * aside) >> 8)) >> 8, (dy + ((dx * aside) >> 8)) >> 8);
}

// Returns the next state of a burning cell. Its age increases by one per step, and at the age burnSteps it becomes
// burnt. Burnt ground stores the upper three of the shade's four bits below three bits of age.
FUNCTION uint nextBurning(uint cell, uint ground) {
  return (cell & 63u) + 1u < uint(stepData.constants.burnSteps) ? cell + 1u : classSpent | (ground & 15u) >> 1u;
}

// Returns the next state of burnt ground, which cools by one age when the turn of its phase comes. The phase, in the
// upper four bits of `ground`, is a hash, so that no rings of equal age are visible.
FUNCTION uint nextBurnt(uint cell, uint ground) {
  bool turn = (((ground >> 4u) - stepData.firstPhase) & 15u) < stepData.phases;
  return turn && (cell & 56u) != 56u ? cell + 8u : cell;
}

// Applies a stroke. The value 1 ignites fuel; the value 0 removes fuel.
FUNCTION uint paintedFuel(uint cell, int value, uint ground) {
  if ((cell & classMask) != classReady) return cell;
  return value == 1 ? classActive : classNobody | (ground & 15u);
}
