// Next cells, collected four at a time by an invocation that owns CELLS of a row, and stored whole.
#ifdef BITS
const int CELLS = 128;
#else
const int CELLS = 16;
#endif

// Four bytes; cells beyond the row's end stay 0. `word` counts from the first of the invocation's cells.
void collect(inout uvec4 block, int word, uint bytes, int left) {
  if (left < 4) bytes &= left <= 0 ? 0u : (1u << uint(left * 8)) - 1u;
#ifdef BITS
  // The lowest bits of the bytes, side by side.
  block[word >> 3] |= (bytes * 0x01020408u >> 24u & 15u) << uint((word & 7) * 4);
#else
  block[word] = bytes;
#endif
}
