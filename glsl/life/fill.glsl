// Random start. Compiles as GLSL and as C++.

// True if a cell is alive in a random start. `fraction` is 2^24 times the fraction of living cells.
FUNCTION bool startsAlive(int x, int y, int seed, int fraction) {
  return int(hash3(uvec3(uint(x), uint(y), uint(seed))).x >> 8u) < fraction;
}
