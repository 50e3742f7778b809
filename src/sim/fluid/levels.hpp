#pragma once
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// One grid of the multigrid that solves for a fluid's pressure.
struct FluidLevel {
  glm::ivec2 cells{0, 0};
  int start = 0;  ///< elements (blocks of 2x2 cells) of the finer levels together

  /// One cell beyond the last one at least, for the faces there.
  [[nodiscard]] glm::ivec2 blocks() const { return cells / 2 + 1; }
  [[nodiscard]] int elements() const { return blocks().x * blocks().y; }
  /// Squares of tileBlocks x tileBlocks blocks where there are cells; a work group takes groupTiles of
  /// them.
  [[nodiscard]] glm::ivec2 tiles() const { return ((cells + 1) / 2 + tileBlocks - 1) / tileBlocks; }
  /// For a list of all tiles there are, in whole rows of groups: an element is a group's tiles.
  [[nodiscard]] int listElements() const {
    const int groups = (tiles().x * tiles().y + groupTiles - 1) / groupTiles;
    return (groups + groupRow - 1) / groupRow * groupRow;
  }
  /// Whether it is worth while to treat those apart that lie in the open.
  [[nodiscard]] bool hasOpenTiles() const { return tiles().x * tiles().y >= 20; }

  static constexpr int tileBlocks = 4, groupTiles = 4;
  static constexpr int groupRow = 64;  ///< groups along x where there are as many
};

/// The grids and the weights of their faces: a finite-volume Poisson equation, sum over a cell's faces of w
/// (phi - phi of the neighbour), w the face's open length over the distance of the two middles, 0 for
/// walls. An open side has phi = 0 on the face itself. A coarse cell is 2x2 finer ones, those at the far
/// borders may be less; what a coarse face lets through is what its fine ones do.
class FluidLevels {
 public:
  /// `left`, `top`: how much of each face is open, 0 to 1, (size.x + 1) x size.y and size.x x (size.y + 1),
  /// x fastest. `wraps`: along x and y, where the first faces are the last ones.
  FluidLevels(glm::ivec2 size, std::vector<double> left, std::vector<double> top, glm::bvec2 wraps);

  [[nodiscard]] const std::vector<FluidLevel>& levels() const { return levels_; }
  /// As glsl/fluid/model.glsl reads them: left face | top face << 16 in units of 2^-12, four cells an
  /// element.
  [[nodiscard]] const std::vector<glm::uvec4>& weights() const { return weights_; }
  /// Words of a level's tiles, x | y << 16, four an element, as kernels take them: for each level those
  /// that lie in the open, then the others, FluidLevel::listElements() each; what is left over is no tile.
  /// `counts`: how many work groups of both there are, a level each.
  [[nodiscard]] std::vector<glm::uvec4> tileLists(std::vector<glm::ivec2>& counts) const;
  [[nodiscard]] int elements() const { return levels_.back().start + levels_.back().elements(); }

 private:
  struct Grid;
  void add(const Grid& grid);
  /// A byte for each block: 1 where all faces of the blocks up to two away are open over a distance of 1,
  /// so that kernels need to look neither at weights nor at borders.
  [[nodiscard]] std::vector<std::uint8_t> openBlocks(const FluidLevel& level) const;

  std::vector<FluidLevel> levels_;
  std::vector<glm::uvec4> weights_;
};

}  // namespace simreel::sim
