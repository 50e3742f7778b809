#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"

#include <cstdint>
#include <string>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// How a cave's cells lie in memory (glsl/cave/cells.glsl).
struct CaveGrid {
  glm::ivec2 size{1, 1};  ///< cells
  /// 32-bit words of a row, whole groups of four.
  [[nodiscard]] int rowWords() const { return (size.x + 127) / 128 * 4; }
  [[nodiscard]] int words() const { return rowWords() * size.y; }
  /// Numbers of cells, those of the words' spare bits included.
  [[nodiscard]] std::int64_t numbers() const { return std::int64_t{32} * words(); }
  [[nodiscard]] glm::ivec2 placeOf(unsigned cell) const {
    const auto pitch = 32U * static_cast<unsigned>(rowWords());
    return {static_cast<int>(cell % pitch), static_cast<int>(cell / pitch)};
  }
};

/// What glsl/cave/cells.glsl is given, a part of the kernels' interfaces.
struct CavePart {
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"rowWords", int> rowWords;
  gl::InOut<"CellBlock"> cells;
};
[[nodiscard]] inline CavePart partOf(const CaveGrid& grid, const gl::Buffer& cells) {
  return {.size = grid.size, .rowWords = grid.rowWords(), .cells = cells};
}

/// What glsl/cave/runs.glsl is given.
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

/// One kind of region: of rock, joined over corners too, or of open cells, joined over edges.
enum class CaveKind { open, rock };
inline constexpr unsigned noCell = 0xffffffffU;

/// Regions of a cave's cells by connected components on the GPU: exact, the same on every device.
class CaveRegions {
 public:
  struct Largest {
    unsigned cells = 0;       ///< 0: there is no region of that kind
    unsigned first = noCell;  ///< its lowest cell
  };

  CaveRegions(const std::string& name, const CaveGrid& grid);

  /// Names every region of that kind by its lowest cell, and counts its cells. Waits for the GPU.
  void label(const gl::Buffer& cells, CaveKind kind);
  /// Of those labelled last, the one with the most cells; of several, the one with the lowest cell.
  [[nodiscard]] Largest largest(const gl::Buffer& cells);
  /// Turns those labelled last that have fewer cells than `fewest` into the other kind, but not the one
  /// whose lowest cell is `kept`. Labels are out of date then.
  void remove(const gl::Buffer& cells, unsigned fewest, unsigned kept);

  /// Of runs: 32-bit words, one for each number of a cell (glsl/cave/runs.glsl).
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
