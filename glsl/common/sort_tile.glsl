// Declarations common to the three kernels of a radix sort pass. The first kernel counts the records of each tile by
// digit. The second kernel sums the counts over the tiles. The third kernel moves every record to the index (number of
// records with lower digits) + (records with the same digit in earlier tiles) + (records with the same digit earlier in
// the tile). The counts of the sixteen digits take four elements of four words.
#include "common/sort_bindings.glsl"
#include "common/words.glsl"
INPUT_WORDS(recordsBinding, RecordBlock, records)
STATE_WORDS(digitsBinding, DigitBlock, digits)
uniform int count;        // number of records to sort
uniform int tiles;
uniform int tileRecords;  // number of records per tile; a tile is processed by one invocation (texel path) or by one
                          // workgroup (storage path, 2048 records)
uniform int word;         // index of the word of a record that holds the digit: 0 or 1
uniform int shift;        // bit offset of the digit in the record's word

const int threads = 256;
const int perThread = 8;  // number of records that each invocation of a workgroup processes; storage path only

uint digitOf(uvec4 record) {
  return ((word == 0 ? record.x : record.y) >> uint(shift)) & 15u;
}
