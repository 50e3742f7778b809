// Trail of a cell: a byte that is `bright` while the cell lives, and after its death trail, trail - 1, ..., 0. Four
// bytes per word. Compiles as GLSL and as C++.

// Returns 1 in each byte that is not zero.
FUNCTION uint notZero(uint bytes) {
  return ((((bytes & 0x7f7f7f7fu) + 0x7f7f7f7fu) | bytes) & 0x80808080u) >> 7u;
}

// Returns four trail bytes after a step. `alive` holds the four cells in its lowest bits; `drop` is bright - trail.
FUNCTION uint fadedTrail(uint bytes, uint alive, uint bright, uint drop) {
  uint living = ((alive & 15u) * 0x00204081u) & 0x01010101u;
  uint died = 0x01010101u ^ notZero(bytes ^ (bright * 0x01010101u));
  uint faded = bytes - notZero(bytes) - died * (drop - 1u);
  uint mask = living * 255u;
  return (faded & ~mask) | (living * bright);
}
