#pragma once
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// One grid of the multigrid pressure solver.
struct FluidLevel {
  glm::ivec2 cells{0, 0};
  int start = 0;  ///< Index of the level's first element: the number of elements (blocks of 2x2 cells) in
                  ///< all finer levels.

  /// Returns the grid size in blocks. The blocks cover at least one additional cell per axis, which holds
  /// the faces beyond the last cell.
  [[nodiscard]] glm::ivec2 blocks() const { return cells / 2 + 1; }
  [[nodiscard]] int elements() const { return blocks().x * blocks().y; }
  /// Returns the number of tiles (tileBlocks x tileBlocks blocks) that cover the cells. A workgroup
  /// processes groupTiles tiles.
  [[nodiscard]] glm::ivec2 tiles() const { return ((cells + 1) / 2 + tileBlocks - 1) / tileBlocks; }
  /// Returns the capacity, in elements, of a list of all tiles, rounded up to whole rows of workgroups. One
  /// element holds the tiles of one workgroup.
  [[nodiscard]] int listElements() const {
    const int groups = (tiles().x * tiles().y + groupTiles - 1) / groupTiles;
    return (groups + groupRow - 1) / groupRow * groupRow;
  }
  /// Returns true if the level is so large that a separate kernel for open tiles saves time. An open tile
  /// has no wall within four cells (glsl/fluid/tiles.glsl).
  [[nodiscard]] bool hasOpenTiles() const { return tiles().x * tiles().y >= 20; }

  static constexpr int tileBlocks = 4, groupTiles = 4;
  static constexpr int groupRow = 64;  ///< Maximum number of workgroups along x.
};

/// Multigrid hierarchy: the grids and the weights of their faces. Each grid discretizes a Poisson equation
/// by finite volumes: the left-hand side of a cell is the sum of w (phi - phi_neighbour) over its faces,
/// where w is the face's open length divided by the distance of the two cell centres, 0 for walls. At an
/// open side, phi = 0 on the face. A coarse cell consists of 2x2 finer cells, or fewer at the far borders.
/// The opening of a coarse face is the sum of the openings of its fine faces.
class FluidLevels {
 public:
  /// `left` and `top` hold the open fraction of each face, 0 to 1, in arrays of (size.x + 1) x size.y and
  /// size.x x (size.y + 1) with x fastest. `wraps` is true for each axis on which the grid is periodic; the
  /// first and last faces of that axis are the same.
  FluidLevels(glm::ivec2 size, std::vector<double> left, std::vector<double> top, glm::bvec2 wraps);

  [[nodiscard]] const std::vector<FluidLevel>& levels() const { return levels_; }
  /// Returns the weights as glsl/fluid/model.glsl reads them: left face | top face << 16, in units of
  /// 2^-12; an element holds four cells.
  [[nodiscard]] const std::vector<glm::uvec4>& weights() const { return weights_; }
  /// Returns the tile lists as kernels read them. A tile is the word x | y << 16, and an element holds four
  /// tiles. Each level has a list of open tiles and a list of the other tiles, each of
  /// FluidLevel::listElements() elements; unused words do not denote a tile. `counts` receives the number
  /// of workgroups for both lists of each level.
  [[nodiscard]] std::vector<glm::uvec4> tileLists(std::vector<glm::ivec2>& counts) const;
  [[nodiscard]] int elements() const { return levels_.back().start + levels_.back().elements(); }

 private:
  struct Grid;
  void add(const Grid& grid);
  /// Returns one byte per block. It is 1 if all faces of all blocks up to two blocks away are fully open
  /// and have weight 1, so that kernels can ignore weights and borders.
  [[nodiscard]] std::vector<std::uint8_t> openBlocks(const FluidLevel& level) const;

  std::vector<FluidLevel> levels_;
  std::vector<glm::uvec4> weights_;
};

}  // namespace simreel::sim
