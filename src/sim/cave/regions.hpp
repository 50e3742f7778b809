#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"

#include <cstdint>
#include <string>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Memory layout of a cave's cells (glsl/cave/cells.glsl).
struct CaveGrid {
  glm::ivec2 size{1, 1};  ///< Size of the grid in cells.
  /// Returns the number of 32-bit words per row, a multiple of four.
  [[nodiscard]] int rowWords() const { return (size.x + 127) / 128 * 4; }
  [[nodiscard]] int words() const { return rowWords() * size.y; }
  /// Number of cell indices, including the indices of the unused bits at the end of rows.
  [[nodiscard]] std::int64_t numbers() const { return std::int64_t{32} * words(); }
  [[nodiscard]] glm::ivec2 placeOf(unsigned cell) const {
    const auto pitch = 32U * static_cast<unsigned>(rowWords());
    return {static_cast<int>(cell % pitch), static_cast<int>(cell / pitch)};
  }
};

/// Part of a kernel interface: members of glsl/cave/cells.glsl.
struct CavePart {
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"rowWords", int> rowWords;
  gl::InOut<"CellBlock"> cells;
};
[[nodiscard]] inline CavePart partOf(const CaveGrid& grid, const gl::Buffer& cells) {
  return {.size = grid.size, .rowWords = grid.rowWords(), .cells = cells};
}

/// Part of a kernel interface: members of glsl/cave/runs.glsl.
struct CaveRunsPart {
  CavePart cave;
  gl::InOut<"LabelBlock"> labels;
  gl::InOut<"TallyBlock"> tally;
  gl::InOut<"FlagBlock"> flags;
};
template <gl::Name path>
struct CaveRunsKernel {
  static constexpr auto file = path.text;
  struct Variant {
    gl::Flag<"ROCK"> rock;
  };
  CaveRunsPart part;
};
struct CaveLargest;
struct CaveRemove;

/// Kind of region: rock cells connected over edges and corners, or open cells connected over edges only.
enum class CaveKind { open, rock };
inline constexpr unsigned noCell = 0xffffffffU;

/// Computes the connected components of a cave's cells on the GPU. The result is exact and the same on
/// every device.
class CaveRegions {
 public:
  struct Largest {
    unsigned cells = 0;       ///< Number of cells; 0 if there is no region of this kind.
    unsigned first = noCell;  ///< Lowest cell index in the region.
  };

  CaveRegions(const std::string& name, const CaveGrid& grid);

  /// Labels every region of this kind with the region's lowest cell index, and counts the region's cells.
  /// Waits for the GPU.
  void label(const gl::Buffer& cells, CaveKind kind);
  /// Returns the region with the most cells among the regions labelled last. Among equal regions, it is the
  /// one with the lowest cell.
  [[nodiscard]] Largest largest(const gl::Buffer& cells);
  /// Among the regions labelled last, converts each region with fewer than `fewest` cells to the other
  /// kind, except for the region whose lowest cell is `kept`. Afterwards the labels are out of date.
  void remove(const gl::Buffer& cells, unsigned fewest, unsigned kept);

  /// Returns the labels of runs: one 32-bit word per cell index (glsl/cave/runs.glsl).
  [[nodiscard]] const gl::Buffer& labels() const { return labels_; }
  [[nodiscard]] const gl::Buffer& tally() const { return tally_; }

 private:
  struct Kernels {
    gl::Kernel<CaveRunsKernel<"cave/label_start.comp">> start;
    gl::Kernel<CaveRunsKernel<"cave/label_join.comp">> join;
    gl::Kernel<CaveRunsKernel<"cave/label_end.comp">> end;
    gl::Kernel<CaveLargest> largest;
    gl::Kernel<CaveRemove> remove;
  };
  [[nodiscard]] const Kernels& kernels() const { return kernels_[static_cast<std::size_t>(kind_)]; }
  [[nodiscard]] CaveRunsPart part(const gl::Buffer& cells) const {
    return {partOf(grid_, cells), labels_, tally_, flags_};
  }

  std::string name_;
  CaveGrid grid_;
  CaveKind kind_ = CaveKind::open;
  Kernels kernels_[2];
  gl::Buffer labels_, tally_, flags_;
};

}  // namespace simreel::sim
