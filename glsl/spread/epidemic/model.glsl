// Kermack and McKendrick's model as an automaton. Compiles as GLSL and, inside a struct that has `stepData`
// (EpidemicStep), as C++.

// A susceptible cell meets eight others drawn from the whole grid, each infected with probability infected / people:
// it stays well with (1 - x)^8, x = beta infected / people. With q = 1 - (1 - x)^k the next power has
// 1 - (1 - q)^2 = q (2 - q), where nothing cancels.
FUNCTION uint mixedThreshold(uint infected) {
  precise float q = float(int(infected >> 12u)) * stepData.per4096 + float(int(infected & 4095u)) * stepData.perInfected;
  for (int i = 0; i < 3; ++i) q = q * (2.0f - q);
  q = clamp(q, 0.0f, 1.0f) * 1073741824.0f;
  return uint(int(q)) << 1u;
}

// The next state of a cell; the threshold is that of a susceptible person's infection.
FUNCTION uint nextPerson(uint cell, uint infectionThreshold, uint random) {
  uint kind = cell & classMask;
  if (kind == classReady) return random < infectionThreshold ? classActive : cell;
  if (kind == classActive) return random < stepData.recovery ? classSpent : cell;
  return kind == classSpent && random < stepData.waning ? classReady : cell;
}

// Strokes: 1 infects the susceptible, 0 makes susceptible and infected immune.
FUNCTION uint paintedPerson(uint cell, int value) {
  uint kind = cell & classMask;
  if (value == 1) return kind == classReady ? classActive : cell;
  return kind == classReady || kind == classActive ? classSpent : cell;
}
