// Random initial state. Compiles as GLSL and as C++.

// Returns true if a cell is alive in the random initial state. `fraction` is the fraction of live cells, multiplied by
// 2^24.
FUNCTION bool startsAlive(int x, int y, int seed, int fraction) {
  return int(hash3(uvec3(uint(x), uint(y), uint(seed))).x >> 8u) < fraction;
}
