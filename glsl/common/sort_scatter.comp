// Third kernel of a radix sort pass: moves every record to its position in the order of the current digit.
#include "common/sort_tile.glsl"
STATE_WORDS(nextRecordsBinding, NextBlock, nextRecords)

// Returns the exclusive prefix sums of the four components.
uvec4 sumsBefore(uvec4 v) {
  return uvec4(0u, v.x, v.x + v.y, v.x + v.y + v.z);
}
uint sumOf(uvec4 v) {
  return v.x + v.y + v.z + v.w;
}

#ifdef TEXEL_PATH
layout(local_size_x = 16) in;

void main() {
  int tile = int(gl_GlobalInvocationID.x);
  if (tile >= tiles) return;
  // Destination index of the next record for each digit.
  uvec4 total0 = LOAD_WORDS(digits, tiles * 4);
  uvec4 total1 = LOAD_WORDS(digits, tiles * 4 + 1);
  uvec4 total2 = LOAD_WORDS(digits, tiles * 4 + 2);
  uvec4 total3 = LOAD_WORDS(digits, tiles * 4 + 3);
  uint lower = 0u;
  uvec4 next0 = LOAD_WORDS(digits, tile * 4) + sumsBefore(total0);
  lower += sumOf(total0);
  uvec4 next1 = LOAD_WORDS(digits, tile * 4 + 1) + sumsBefore(total1) + lower;
  lower += sumOf(total1);
  uvec4 next2 = LOAD_WORDS(digits, tile * 4 + 2) + sumsBefore(total2) + lower;
  lower += sumOf(total2);
  uvec4 next3 = LOAD_WORDS(digits, tile * 4 + 3) + sumsBefore(total3) + lower;
  int first = tile * tileRecords;
  int last = min(first + tileRecords, count);
  for (int i = first; i < last; ++i) {
    uvec4 record = LOAD_INPUT_WORDS(records, i);
    uint digit = digitOf(record);
    uvec4 here0 = uvec4(equal(uvec4(digit), uvec4(0u, 1u, 2u, 3u)));
    uvec4 here1 = uvec4(equal(uvec4(digit), uvec4(4u, 5u, 6u, 7u)));
    uvec4 here2 = uvec4(equal(uvec4(digit), uvec4(8u, 9u, 10u, 11u)));
    uvec4 here3 = uvec4(equal(uvec4(digit), uvec4(12u, 13u, 14u, 15u)));
    uint place = sumOf(next0 * here0 + next1 * here1 + next2 * here2 + next3 * here3);
    STORE_WORDS(nextRecords, int(place), record);
    next0 += here0;
    next1 += here1;
    next2 += here2;
    next3 += here3;
  }
}
#else
layout(local_size_x = threads) in;
shared uint ranks[16 * threads];  // rank counters; the index is the digit, then the invocation
shared uint sums[threads];
shared uint places[16];

// Replaces `ranks` by its exclusive prefix sums. Each invocation sums sixteen neighbouring entries, then a scan runs
// over the invocations.
void scanRanks(int thread) {
  uint sum = 0u;
  for (int k = 0; k < 16; ++k) {
    uint here = ranks[thread * 16 + k];
    ranks[thread * 16 + k] = sum;
    sum += here;
  }
  sums[thread] = sum;
  barrier();
  for (int reach = 1; reach < threads; reach *= 2) {
    uint before = thread >= reach ? sums[thread - reach] : 0u;
    barrier();
    sums[thread] += before;
    barrier();
  }
  uint before = sums[thread] - sum;
  for (int k = 0; k < 16; ++k) ranks[thread * 16 + k] += before;
  barrier();
}

void main() {
  int thread = int(gl_LocalInvocationID.x);
  int tile = int(gl_WorkGroupID.x);
  int first = (tile * threads + thread) * perThread;
  for (int digit = 0; digit < 16; ++digit) ranks[digit * threads + thread] = 0u;
  barrier();
  uvec4 mine[perThread];
  for (int k = 0; k < perThread; ++k)
    if (first + k < count) {
      mine[k] = records[first + k];
      ranks[int(digitOf(mine[k])) * threads + thread] += 1u;
    }
  barrier();
  scanRanks(thread);
  // For each digit, destination index of this tile's first record minus the rank of that record in the tile.
  if (thread < 16) {
    uint lower = 0u;
    for (int digit = 0; digit < thread; ++digit) lower += digits[tiles * 4 + digit / 4][digit % 4];
    places[thread] = lower + digits[tile * 4 + thread / 4][thread % 4] - ranks[thread * threads];
  }
  barrier();
  for (int k = 0; k < perThread; ++k)
    if (first + k < count) {
      int digit = int(digitOf(mine[k]));
      uint rank = ranks[digit * threads + thread];
      ranks[digit * threads + thread] = rank + 1u;
      nextRecords[places[digit] + rank] = mine[k];
    }
}
#endif
