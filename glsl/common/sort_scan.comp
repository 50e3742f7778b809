// Second kernel of a radix sort pass: replaces the digit counts of each tile by their exclusive prefix sums over the
// tiles. The totals are stored after the last tile.
#include "common/sort_tile.glsl"
#ifdef TEXEL_PATH
layout(local_size_x = 4) in;  // each invocation sums the counts of four digits

void main() {
  int quad = int(gl_LocalInvocationID.x);
  uvec4 sum = uvec4(0u);
  for (int tile = 0; tile < tiles; ++tile) {
    uvec4 here = LOAD_WORDS(digits, tile * 4 + quad);
    STORE_WORDS(digits, tile * 4 + quad, sum);
    sum += here;
  }
  STORE_WORDS(digits, tiles * 4 + quad, sum);
}
#else
const int segments = 256;
layout(local_size_x = 4 * segments) in;
shared uvec4 sums[4 * segments];

void main() {
  int thread = int(gl_LocalInvocationID.x);
  int quad = thread % 4;
  int segment = thread / 4;
  int length_ = (tiles - 1) / segments + 1;
  int first = min(segment * length_, tiles);
  int last = min(first + length_, tiles);
  uvec4 sum = uvec4(0u);
  for (int tile = first; tile < last; ++tile) sum += digits[tile * 4 + quad];
  sums[thread] = sum;
  barrier();
  for (int reach = 1; reach < segments; reach *= 2) {
    uvec4 before = segment >= reach ? sums[thread - reach * 4] : uvec4(0u);
    barrier();
    sums[thread] += before;
    barrier();
  }
  uvec4 running = sums[thread] - sum;
  for (int tile = first; tile < last; ++tile) {
    uvec4 here = digits[tile * 4 + quad];
    digits[tile * 4 + quad] = running;
    running += here;
  }
  if (segment == segments - 1) digits[tiles * 4 + quad] = sums[thread];
}
#endif
