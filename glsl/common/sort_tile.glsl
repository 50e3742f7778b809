// What the three kernels of a sorting pass share: records are counted tile by tile, the counts are summed over
// the tiles before, and every record moves to (records with lower digits) + (records of its digit in tiles
// before) + (those before it in its tile). Counts of the sixteen digits are four elements of four words.
#include "common/sort_bindings.glsl"
#include "common/words.glsl"
INPUT_WORDS(recordsBinding, RecordBlock, records)
STATE_WORDS(digitsBinding, DigitBlock, digits)
uniform int count;        // of records
uniform int tiles;
uniform int tileRecords;  // texels: records an invocation counts; storage: 2048
uniform int word;         // 0 or 1, of the record
uniform int shift;        // of the digit in it

const int threads = 256;
const int perThread = 8;  // of a work group on the storage path

uint digitOf(uvec4 record) {
  return ((word == 0 ? record.x : record.y) >> uint(shift)) & 15u;
}
