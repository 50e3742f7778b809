// Epidemic model of Kermack and McKendrick as a cellular automaton. Compiles as GLSL and, inside a struct with
// `stepData` (EpidemicStep), as C++.

// Infection with global mixing: a susceptible cell meets eight random cells of the whole grid and stays healthy with
// the probability (1 - x)^8, where x = beta infected / people. With q = 1 - (1 - x)^k, doubling k gives 1 - (1 - q)^2 =
// q (2 - q), a form without cancellation. Returns the threshold for a random number.
FUNCTION uint mixedThreshold(uint infected) {
  precise float q = float(int(infected >> 12u)) * stepData.per4096 + float(int(infected & 4095u)) * stepData.perInfected;
  for (int i = 0; i < 3; ++i) q = q * (2.0f - q);
  q = clamp(q, 0.0f, 1.0f) * 1073741824.0f;
  return uint(int(q)) << 1u;
}

// Returns the next state of a cell. `infectionThreshold` applies if the cell is susceptible.
FUNCTION uint nextPerson(uint cell, uint infectionThreshold, uint random) {
  uint kind = cell & classMask;
  if (kind == classReady) return random < infectionThreshold ? classActive : cell;
  if (kind == classActive) return random < stepData.recovery ? classSpent : cell;
  return kind == classSpent && random < stepData.waning ? classReady : cell;
}

// Applies a stroke. The value 1 infects susceptible cells; the value 0 makes susceptible and infected cells immune.
FUNCTION uint paintedPerson(uint cell, int value) {
  uint kind = cell & classMask;
  if (value == 1) return kind == classReady ? classActive : cell;
  return kind == classReady || kind == classActive ? classSpent : cell;
}
