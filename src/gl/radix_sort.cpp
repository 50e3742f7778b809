#include "gl/radix_sort.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"

#include <utility>

namespace simreel::shader::sort {
#include "glsl/common/sort_bindings.glsl"
}

namespace simreel::gl {

namespace {

// Number of records of a tile. On the texel path one invocation counts a tile with 8-bit counters. On the
// storage path a workgroup of 256 invocations ranks a tile in shared memory, 8 records per invocation
// (sort_tile.glsl).
constexpr int texelTile = 64;
constexpr int maxTexelTile = 255;
constexpr int storageTile = 2048;
// A software driver ends a shader's loops after 65,535 iterations, and the scan loops over tiles.
constexpr int maxTexelTiles = 65000;

constexpr int tilesOf(int count, int tile) {
  return (count - 1) / tile + 1;
}

int tileFor(int capacity) {
  if (memoryPath() == MemoryPath::storage) return storageTile;
  return tilesOf(capacity, texelTile) > maxTexelTiles ? maxTexelTile : texelTile;
}

}  // namespace

RadixSort::RadixSort(const std::string& label, int capacity)
    : capacity_(capacity), texels_(memoryPath() == MemoryPath::texel), tile_(tileFor(capacity)) {
  SIMREEL_CHECK(capacity > 0);
  if (texels_ && tilesOf(capacity, maxTexelTile) > maxTexelTiles)
    fail(ExitCode::device, "{} has {} records, a software driver sorts at most {}; make it smaller", label,
         capacity, maxTexelTile * maxTexelTiles);
  records_ = WordsArray(label + " records", capacity);
  next_ = WordsArray(label + " next records", capacity);
  digits_ = WordsArray(label + " digits", 4 * (tilesOf(capacity, tile_) + 1));
  const Defines defines = kernelDefines(false);
  count_ = Program::compute("common/sort_count.comp", defines);
  scan_ = Program::compute("common/sort_scan.comp", defines);
  scatter_ = Program::compute("common/sort_scatter.comp", defines);
}

void RadixSort::sort(int count, int lowBits, int highBits) {
  SIMREEL_CHECK(count <= capacity_ && lowBits % 4 == 0 && highBits % 4 == 0);
  if (count <= 0) return;
  for (int shift = 0; shift < lowBits; shift += 4) pass(count, 0, shift);
  for (int shift = 0; shift < highBits; shift += 4) pass(count, 1, shift);
  barrier();
}

void RadixSort::pass(int count, int word, int shift) {
  const int tiles = tilesOf(count, tile_);
  for (const Program* program : {&count_, &scan_, &scatter_}) {
    program->set("count", count);
    program->set("tiles", tiles);
    program->set("tileRecords", tile_);
    program->set("word", word);
    program->set("shift", shift);
  }
  // One tile is processed by one invocation (texels) or by a workgroup of 256 (storage).
  const int invocations = texels_ ? tiles : tiles * 256;
  records_.bindInput(shader::sort::recordsBinding);
  next_.bindState(shader::sort::nextRecordsBinding);
  digits_.bindState(shader::sort::digitsBinding);
  barrier();
  count_.dispatch(invocations);
  barrier();
  scan_.dispatch(1);
  barrier();
  scatter_.dispatch(invocations);
  std::swap(records_, next_);
}

}  // namespace simreel::gl
