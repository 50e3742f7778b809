#pragma once
#include "sim/fluid/levels.hpp"
#include "sim/fluid/model.hpp"
#include "sim/fluid/parameters.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Signed distances in pixels to the bright area of an image, negative inside. The brightness of a pixel
/// counts as its coverage, so an anti-aliased edge is located with subpixel precision.
class PictureDistances {
 public:
  PictureDistances() = default;
  /// Areas brighter than `threshold` (0 to 1) are solid. Throws UserError if the image cannot be read.
  PictureDistances(const std::filesystem::path& file, double threshold);
  /// Computes the distances from brightness values: `levels` holds the brightness of each pixel, 0 to 1, x
  /// fastest.
  PictureDistances(glm::ivec2 size, const std::vector<double>& levels, double threshold);

  /// Returns the distance at a point given in pixels; (0, 0) is the top left corner of the image.
  [[nodiscard]] double at(glm::dvec2 p) const;
  [[nodiscard]] glm::ivec2 size() const { return size_ - 2 * margin; }

 private:
  static constexpr int margin = 4;  ///< Width of an empty margin around the image, in pixels.
  void measure(std::vector<double> field);

  glm::ivec2 size_{0, 0};
  std::vector<double> distances_;
};

/// Obstacles on the fluid's grid at one time: partly open faces, obstacle velocities, and enclosed pockets
/// of fluid. The openings of faces are linearly interpolated from the distances at cell corners; openings
/// below 1/16 are closed.
class FluidSolids {
 public:
  /// Places the obstacles at `time` (seconds) and computes their velocities from the motion since `time` -
  /// `dt`. `pictures` has one entry per obstacle, which is used for the shape "image". `sides` gives the
  /// velocities at the grid's sides.
  FluidSolids(const FluidParameters& p, const std::vector<PictureDistances>& pictures, double time,
              double dt, const shader::FluidStep& sides);

  [[nodiscard]] const FluidLevels& levels() const { return levels_; }
  /// Returns one byte per cell, x fastest: 1 if all faces of the cell are closed.
  [[nodiscard]] const std::vector<std::uint8_t>& solid() const { return solid_; }
  /// Returns the data for the kernels: first the weights of all levels; then, if there are obstacles, the
  /// words of solidWord (glsl/fluid/walls.glsl) in blocks of 2x2 cells; then FluidLevels::tileLists.
  [[nodiscard]] const std::vector<glm::uvec4>& words() const { return words_; }
  [[nodiscard]] int solidsStart() const { return levels_.elements(); }
  [[nodiscard]] int tilesStart() const { return tilesStart_; }
  /// Returns for each level the number of workgroups for open tiles and for other tiles.
  [[nodiscard]] const std::vector<glm::ivec2>& tileGroups() const { return tileGroups_; }
  /// Returns a cell's packed word of distance, obstacle index and pocket index.
  [[nodiscard]] std::uint32_t wordAt(int x, int y) const;
  [[nodiscard]] const shader::FluidSolidSet& set() const { return set_; }
  /// pockets() returns the number of disconnected regions of fluid. pocketOf() returns the zero-based
  /// region index of each cell, -1 if it is solid.
  [[nodiscard]] int pockets() const { return pockets_; }
  [[nodiscard]] const std::vector<int>& pocketOf() const { return pocketOf_; }
  /// Returns the closed fractions, 0 to 1, of a cell's left, right, top and bottom faces. Only obstacles
  /// count, not walls at the grid's sides.
  [[nodiscard]] glm::dvec4 closedAt(int x, int y) const;
  /// Returns the rigid-body velocity (cells/s) of the obstacle nearest to a cell, evaluated at a point in
  /// cells.
  [[nodiscard]] glm::dvec2 velocityAt(glm::ivec2 cell, glm::dvec2 point) const;
  /// Returns true if a pocket has to grow or shrink, because it has no open side and walls or inflows
  /// change its volume.
  [[nodiscard]] bool grows() const { return grows_; }
  /// Returns the signed distance (cells) from the centre of cell (x, y) to the nearest obstacle, at most 8.
  [[nodiscard]] double distanceAt(int x, int y) const { return shader::wallDistance(wordAt(x, y)); }

 private:
  struct Nearest;
  FluidSolids(const FluidParameters& p, Nearest nearest);
  [[nodiscard]] std::uint32_t& wordOf(int x, int y);
  void addDistances(const FluidParameters& p, const Nearest& nearest);
  void findSolid();
  void findPockets(glm::bvec2 wraps);
  void balance(const FluidParameters& p, const shader::FluidStep& sides);
  void growPockets(const std::vector<double>& each);
  [[nodiscard]] std::size_t cell(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
  }
  /// Returns the weights of a cell's left and top faces (faceWeights); x and y may equal the grid size.
  [[nodiscard]] glm::vec2 face(int x, int y) const;

  glm::ivec2 size_;
  FluidLevels levels_;
  std::vector<std::uint8_t> solid_;
  std::vector<glm::uvec4> words_;
  std::vector<int> pocketOf_;
  std::vector<glm::ivec2> tileGroups_;
  int pockets_ = 0, tilesStart_ = 0;
  bool grows_ = false;
  shader::FluidSolidSet set_{};
};

}  // namespace simreel::sim
