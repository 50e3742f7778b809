// A fluid's wind over a wildfire's map. Compiles as GLSL and as C++, after common/exact.glsl. A gale is the effect of
// the wind at a cell: the increase of the logarithm of the fire's spread rate along x and along y, as two signed 16-bit
// numbers in units of 1/2048.

const uint stillAir = 0u;

FUNCTION ivec2 galeParts(uint gale) {
  return ivec2(int(gale << 16u) >> 16, int(gale) >> 16);
}

// Converts a velocity (cells/s of the fluid) to the units of a gale, by multiplication with `scale`.
FUNCTION int galePart(float velocity, float scale) {
  precise float share = velocity * scale;
  precise float steps = clamp(share, -15.99f, 15.99f) * 2048.0f + 0.5f;
  return int(floor(steps));
}

FUNCTION uint galeOf(float u, float v, float scale) {
  return (uint(galePart(u, scale)) & 0xffffu) | (uint(galePart(v, scale)) << 16u);
}

// Returns the chance t that the neighbour in direction d (WildfireStep.spread) ignites a cell, multiplied by e^(gale .
// path) and limited to 65536.
FUNCTION uint blownOver(uint t, uint d, uint gale) {
  uint place = d + (d >> 2u);
  int x = int(place % 3u) - 1;
  int y = int(place / 3u) - 1;
  ivec2 parts = galeParts(gale);
  int along = -(x * parts.x + y * parts.y);
  bool straight = x == 0 || y == 0;
  precise float exponent = float(along) * (straight ? 4.8828125e-4f : 3.4526698e-4f);
  precise float chance = float(int(t)) * exactExp(exponent);
  return uint(int(min(chance, 65536.0f)));
}
