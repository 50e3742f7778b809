#include "gl/sort/radix_sort.hpp"

#include "base/error.hpp"
#include "gl/kernel/kernel.hpp"

#include <utility>

namespace simreel::gl {

namespace {

// Number of records per tile. On the texel path, one invocation counts a tile with 8-bit counters. On the
// storage path, a workgroup of 256 invocations ranks a tile in shared memory, 8 records per invocation
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

// Arguments of the three kernels of a pass (sort_tile.glsl).

struct SortArguments {
  Uniform<"count", int> count;
  Uniform<"tiles", int> tiles;
  Uniform<"tileRecords", int> tileRecords;
  Uniform<"word", int> word;
  Uniform<"shift", int> shift;
};

struct SortCount {
  static constexpr auto file = "common/sort_count.comp";
  SortArguments arguments;
  In<"records"> records;
  Out<"digits"> digits;
};

struct SortScan {
  static constexpr auto file = "common/sort_scan.comp";
  SortArguments arguments;
  In<"records"> records;  // declared, but not read; NVIDIA's driver reports it as active
  InOut<"digits"> digits;
};

struct SortScatter {
  static constexpr auto file = "common/sort_scatter.comp";
  SortArguments arguments;
  In<"records"> records;
  In<"digits"> digits;
  Out<"nextRecords"> next;
};

}  // namespace

struct RadixSort::Kernels {
  Kernel<SortCount> count = Kernel<SortCount>(kernelDefines(false));
  Kernel<SortScan> scan = Kernel<SortScan>(kernelDefines(false));
  Kernel<SortScatter> scatter = Kernel<SortScatter>(kernelDefines(false));
};

RadixSort::RadixSort(const std::string& label, int capacity)
    : capacity_(capacity), texels_(memoryPath() == MemoryPath::texel), tile_(tileFor(capacity)) {
  SIMREEL_CHECK(capacity > 0);
  if (texels_ && tilesOf(capacity, maxTexelTile) > maxTexelTiles)
    fail(ExitCode::device, "{} has {} records, a software driver sorts at most {}; make it smaller", label,
         capacity, maxTexelTile * maxTexelTiles);
  records_ = WordsArray(label + " records", capacity);
  next_ = WordsArray(label + " next records", capacity);
  digits_ = WordsArray(label + " digits", 4 * (tilesOf(capacity, tile_) + 1));
  kernels_ = std::make_unique<Kernels>();
}

void RadixSort::sort(int count, int lowBits, int highBits) {
  SIMREEL_CHECK(count <= capacity_ && lowBits % 4 == 0 && highBits % 4 == 0);
  if (count <= 0) return;
  for (int shift = 0; shift < lowBits; shift += 4) pass(count, 0, shift);
  for (int shift = 0; shift < highBits; shift += 4) pass(count, 1, shift);
}

void RadixSort::pass(int count, int word, int shift) {
  const int tiles = tilesOf(count, tile_);
  const SortArguments arguments = {
      .count = count, .tiles = tiles, .tileRecords = tile_, .word = word, .shift = shift};
  // A tile is processed by one invocation (texel path) or by a workgroup of 256 (storage path).
  const int invocations = texels_ ? tiles : tiles * 256;
  kernels_->count.dispatch(invocations, {.arguments = arguments, .records = records_, .digits = digits_});
  kernels_->scan.dispatch(1, {.arguments = arguments, .records = records_, .digits = digits_});
  kernels_->scatter.dispatch(
      invocations, {.arguments = arguments, .records = records_, .digits = digits_, .next = next_});
  std::swap(records_, next_);
}

RadixSort::~RadixSort() = default;

}  // namespace simreel::gl
