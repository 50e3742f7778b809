// Compiles as GLSL and as C++.

// Whether a cell is alive in a random start; fraction: 2^24 times the fraction of the living.
FUNCTION bool startsAlive(int x, int y, int seed, int fraction) {
  return int(hash3(uvec3(uint(x), uint(y), uint(seed))).x >> 8u) < fraction;
}
