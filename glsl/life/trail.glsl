// Trail of a cell: a byte that is `bright` while the cell is alive, and counts down from `trail` to 0 after its death.
// A word holds the trails of four cells. Compiles as GLSL and as C++.

// Returns a word with 1 in each byte that is nonzero in `bytes`, otherwise 0.
FUNCTION uint notZero(uint bytes) {
  return ((((bytes & 0x7f7f7f7fu) + 0x7f7f7f7fu) | bytes) & 0x80808080u) >> 7u;
}

// Returns the trails of four cells after a step. The lowest bits of `alive` tell which of the cells are alive; `drop`
// is bright - trail.
FUNCTION uint fadedTrail(uint bytes, uint alive, uint bright, uint drop) {
  uint living = ((alive & 15u) * 0x00204081u) & 0x01010101u;
  uint died = 0x01010101u ^ notZero(bytes ^ (bright * 0x01010101u));
  uint faded = bytes - notZero(bytes) - died * (drop - 1u);
  uint mask = living * 255u;
  return (faded & ~mask) | (living * bright);
}
