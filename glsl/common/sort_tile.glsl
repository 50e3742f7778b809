// Declarations that the three kernels of a radix sort pass share. The first kernel counts the records of each tile by
// digit, the second sums the counts over the tiles, and the third moves every record to (number of records with lower
// digits) + (records with the same digit in earlier tiles) + (records with the same digit earlier in the tile). The
// counts of the sixteen digits are four elements of four words.
#include "common/sort_bindings.glsl"
#include "common/words.glsl"
INPUT_WORDS(recordsBinding, RecordBlock, records)
STATE_WORDS(digitsBinding, DigitBlock, digits)
uniform int count;        // number of records to sort
uniform int tiles;
uniform int tileRecords;  // number of records per tile; a tile is the work of one invocation (texel path) or one
                          // workgroup (storage path, 2048)
uniform int word;         // index of the word of a record that holds the digit: 0 or 1
uniform int shift;        // bit offset of the digit in the record's word

const int threads = 256;
const int perThread = 8;  // number of records for each invocation of a workgroup, storage path only

uint digitOf(uvec4 record) {
  return ((word == 0 ? record.x : record.y) >> uint(shift)) & 15u;
}
