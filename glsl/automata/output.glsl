// Collects the next cells of an invocation, four at a time, for a single store. An invocation has CELLS cells of a row.
#ifdef BITS
const int CELLS = 128;
#else
const int CELLS = 16;
#endif

// Adds four bytes of cells; cells beyond the row's end stay 0. `word` counts groups of four from the invocation's first
// cell.
void collect(inout uvec4 block, int word, uint bytes, int left) {
  if (left < 4) bytes &= left <= 0 ? 0u : (1u << uint(left * 8)) - 1u;
#ifdef BITS
  // Packs the lowest bits of the four bytes.
  block[word >> 3] |= (bytes * 0x01020408u >> 24u & 15u) << uint((word & 7) * 4);
#else
  block[word] = bytes;
#endif
}
