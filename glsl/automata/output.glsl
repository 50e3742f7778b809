// Collects the next cells of an invocation, four at a time, for a single store. An invocation has CELLS consecutive
// cells of a row.
#ifdef BITS
const int CELLS = 128;
#else
const int CELLS = 16;
#endif

// Adds four cells, given as bytes. Cells beyond the end of the row stay 0. `word` counts groups of four cells from the
// invocation's first cell.
void collect(inout uvec4 block, int word, uint bytes, int left) {
  if (left < 4) bytes &= left <= 0 ? 0u : (1u << uint(left * 8)) - 1u;
#ifdef BITS
  // Packs the lowest bits of the four bytes into four bits.
  block[word >> 3] |= (bytes * 0x01020408u >> 24u & 15u) << uint((word & 7) * 4);
#else
  block[word] = bytes;
#endif
}
