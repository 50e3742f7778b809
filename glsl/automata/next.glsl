// Returns the next state of a cell. `holds` is true if the condition for birth or survival is fulfilled. A live cell
// that does not survive ages through the states above 1. Compiles as GLSL and as C++.
FUNCTION uint agedState(uint state, bool holds, uint states) {
  uint older = state + 1u < states ? state + 1u : 0u;
  return state == 0u ? (holds ? 1u : 0u) : (state == 1u && holds ? 1u : older);
}

// Returns a word with 1 in each byte that equals 1 in `bytes`, otherwise 0.
FUNCTION uint bytesOfOne(uint bytes) {
  uint other = bytes ^ 0x01010101u;
  return (((((other & 0x7f7f7f7fu) + 0x7f7f7f7fu) | other) & 0x80808080u) >> 7u) ^ 0x01010101u;
}
