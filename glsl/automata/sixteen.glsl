// Stores the next cells, sixteen per invocation. If cells are stored as bits, eight invocations with consecutive x
// write one element together; otherwise each invocation writes one element. The including kernel declares
// layout(local_size_x = 8, local_size_y = 4). No invocation may return before storeSixteen().
#ifdef BITS
shared uint sixteens[4][8];
#endif

// Stores 16 cells given as bytes, of which the first `left` cells are in the row. `inside` is false if the invocation
// has no cells.
void storeSixteen(uvec4 bytes, int left, int place, bool inside) {
  for (int i = 0; i < 4; ++i) {
    int here = left - 4 * i;
    if (here < 4) bytes[i] &= here <= 0 ? 0u : (1u << uint(here * 8)) - 1u;
  }
#ifdef BITS
  // Packs the lowest bits of four bytes into four bits.
  uvec4 bits = bytes * 0x01020408u >> 24u & 15u;
  ivec2 lane = ivec2(gl_LocalInvocationID.xy);
  sixteens[lane.y][lane.x] = bits.x | bits.y << 4u | bits.z << 8u | bits.w << 12u;
  barrier();
  if (lane.x != 0 || !inside) return;
  uvec4 element;
  for (int i = 0; i < 4; ++i) element[i] = sixteens[lane.y][2 * i] | sixteens[lane.y][2 * i + 1] << 16u;
  STORE_WORDS(newCells, place, element);
#else
  if (inside) STORE_WORDS(newCells, place, bytes);
#endif
}

#ifdef BITS
const int LANES = 8;  // Number of invocations that write one element together
#else
const int LANES = 1;
#endif
