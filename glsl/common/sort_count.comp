// First kernel of a radix sort pass: counts the records of each tile by digit (0 to 15). With TEXEL_PATH, one
// invocation counts one tile; otherwise, one workgroup counts one tile.
#include "common/sort_tile.glsl"
#ifdef TEXEL_PATH
layout(local_size_x = 16) in;

void main() {
  int tile = int(gl_GlobalInvocationID.x);
  if (tile >= tiles) return;
  int first = tile * tileRecords;
  int last = min(first + tileRecords, count);
  // Sixteen 8-bit counters, packed into the bytes of four words.
  uvec4 packed_ = uvec4(0u);
  for (int i = first; i < last; ++i) {
    uint digit = digitOf(LOAD_INPUT_WORDS(records, i));
    uvec4 here = uvec4(equal(uvec4(digit >> 2u), uvec4(0u, 1u, 2u, 3u)));
    packed_ += here << ((digit & 3u) * 8u);
  }
  for (int quad = 0; quad < 4; ++quad)
    STORE_WORDS(digits, tile * 4 + quad, (uvec4(packed_[quad]) >> uvec4(0u, 8u, 16u, 24u)) & 255u);
}
#else
layout(local_size_x = threads) in;
const int copies = 32;  // number of copies of each counter, so that few invocations use the same copy
shared uint counters[16 * copies];
shared uint sums[16];

void main() {
  int thread = int(gl_LocalInvocationID.x);
  int tile = int(gl_WorkGroupID.x);
  for (int i = thread; i < 16 * copies; i += threads) counters[i] = 0u;
  barrier();
  for (int k = 0; k < perThread; ++k) {
    int i = tile * threads * perThread + k * threads + thread;
    if (i < count) atomicAdd(counters[int(digitOf(records[i])) * copies + thread % copies], 1u);
  }
  barrier();
  if (thread < 16) {
    uint sum = 0u;
    for (int k = 0; k < copies; ++k) sum += counters[thread * copies + (k + thread) % copies];
    sums[thread] = sum;
  }
  barrier();
  if (thread < 4)
    digits[tile * 4 + thread] =
        uvec4(sums[thread * 4], sums[thread * 4 + 1], sums[thread * 4 + 2], sums[thread * 4 + 3]);
}
#endif
