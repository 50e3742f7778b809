// A fire that walks from cell to neighbouring cell. Compiles as GLSL and, inside a struct that has `stepData`
// (WildfireStep) and climbFactor(int), as C++. gale.glsl comes before it.

// The chance t that a neighbour lights a cell, times e^(slope * tangent) of the ground's rise on the way from it, at
// most certain. An incline holds the rises to the right and downwards in sixteenths of a cell a cell, each plus 128, in
// eight bits. climbFactor(i), which the includer gives, is e^(slope (i - 128) / 16) for i below 256, then the same with
// the rise over the root of two: a neighbour diagonally is that far away, and lies both aside and above or below.
FUNCTION uint climbed(uint t, uint d, uint incline) {
  uint place = d + (d >> 2u);  // of the eight around, in three rows of three
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

// Chance in 1/65536 that a cell catches fire from its burning neighbours (a bit each, in the order of
// WildfireStep.spread). Fuel 0 to 256 weighs each chance t; chances join as p + t (1 - p), in integers.
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

// Fuel bytes 0 to 255 as 0 to 256, so that the fullest counts whole.
FUNCTION uint fuelWeight(uint level) {
  return level + (level >> 7u);
}

// The longest flight of an ember onto a cell with this gale (1/256 cell), up to what emberFlight() can take.
FUNCTION ivec2 galeFlight(uint gale) {
  ivec2 parts = galeParts(gale);
  precise float x = float(parts.x) * stepData.emberReach;
  precise float y = float(parts.y) * stepData.emberReach;
  return ivec2(int(clamp(x, -512000.0f, 512000.0f)), int(clamp(y, -512000.0f, 512000.0f)));
}

// From where an ember falls onto a cell now: its displacement, along the wind and to its side, both by hash. `longest`: 1/256 cell.
FUNCTION ivec2 emberFlight(uvec3 random, ivec2 longest) {
  int along = int(random.y >> 20u);            // 0 to 4095
  int side = int(random.z >> 20u) - 2048;      // -2048 to 2047
  int aside = (stepData.emberSpread * side) >> 11;  // 1/256 of the flight
  int dx = (longest.x * along) >> 12;
  int dy = (longest.y * along) >> 12;
  return ivec2((dx - ((dy * aside) >> 8)) >> 8, (dy + ((dx * aside) >> 8)) >> 8);
}

// What a fire leaves: burnt ground keeps the upper three of its shade's four bits below the three of its age.
// A burning cell ages by one in a step.
FUNCTION uint nextBurning(uint cell, uint ground) {
  return (cell & 63u) + 1u < uint(stepData.constants.burnSteps) ? cell + 1u : classSpent | (ground & 15u) >> 1u;
}

// Burnt ground cools by one age when it is the turn of its phase, the upper four bits of `ground`, which are a hash:
// no rings of equal age show.
FUNCTION uint nextBurnt(uint cell, uint ground) {
  bool turn = (((ground >> 4u) - stepData.firstPhase) & 15u) < stepData.phases;
  return turn && (cell & 56u) != 56u ? cell + 8u : cell;
}

// Strokes: 1 lights fuel, 0 clears it away.
FUNCTION uint paintedFuel(uint cell, int value, uint ground) {
  if ((cell & classMask) != classReady) return cell;
  return value == 1 ? classActive : classNobody | (ground & 15u);
}
