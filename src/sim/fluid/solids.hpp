#pragma once
#include "sim/fluid/levels.hpp"
#include "sim/fluid/model.hpp"
#include "sim/fluid/parameters.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Signed distances to the white of a picture, in its pixels, negative within. Levels are how much of a
/// pixel is covered, so an anti-aliased edge is found to a fraction of a pixel.
class PictureDistances {
 public:
  PictureDistances() = default;
  /// What is whiter than `threshold` (0 to 1) is solid. Throws UserError for a picture that cannot be read.
  PictureDistances(const std::filesystem::path& file, double threshold);
  /// `levels`: x fastest, 0 to 1.
  PictureDistances(glm::ivec2 size, const std::vector<double>& levels, double threshold);

  /// At a point in pixels, (0, 0) the top left corner of the picture.
  [[nodiscard]] double at(glm::dvec2 p) const;
  [[nodiscard]] glm::ivec2 size() const { return size_ - 2 * margin; }

 private:
  static constexpr int margin = 4;  ///< pixels around the picture in which there is nothing
  void measure(std::vector<double> field);

  glm::ivec2 size_{0, 0};
  std::vector<double> distances_;
};

/// What stands in a fluid at one moment, as its grid sees it: faces that are partly open, what moves,
/// pockets that are cut off. Openings go by distances at the corners of cells, linear between them; those
/// below 1/16 are closed.
class FluidSolids {
 public:
  /// Where the obstacles are at `time` (s), and how they have moved since `time` - `dt`. `pictures`: one
  /// each, of shape "image". `sides`: what they let in.
  FluidSolids(const FluidParameters& p, const std::vector<PictureDistances>& pictures, double time,
              double dt, const shader::FluidStep& sides);

  [[nodiscard]] const FluidLevels& levels() const { return levels_; }
  /// A byte a cell, x fastest: 1 where no face lets anything through.
  [[nodiscard]] const std::vector<std::uint8_t>& solid() const { return solid_; }
  /// For the kernels: the weights of all levels, then the words of solidWord (glsl/fluid/walls.glsl) in
  /// blocks of 2x2 cells, where there are obstacles, then FluidLevels::tileLists.
  [[nodiscard]] const std::vector<glm::uvec4>& words() const { return words_; }
  [[nodiscard]] int solidsStart() const { return levels_.elements(); }
  [[nodiscard]] int tilesStart() const { return tilesStart_; }
  /// Of each level, work groups for those in the open and for the others.
  [[nodiscard]] const std::vector<glm::ivec2>& tileGroups() const { return tileGroups_; }
  /// A word of a cell: distance, obstacle, pocket.
  [[nodiscard]] std::uint32_t wordAt(int x, int y) const;
  [[nodiscard]] const shader::FluidSolidSet& set() const { return set_; }
  /// Parts of the fluid that are not joined to each other, and which of them (from 0) a cell is in; -1:
  /// solid.
  [[nodiscard]] int pockets() const { return pockets_; }
  [[nodiscard]] const std::vector<int>& pocketOf() const { return pocketOf_; }
  /// How much of a cell's four faces obstacles close: left, right, top, bottom, 0 to 1; of borders nothing.
  [[nodiscard]] glm::dvec4 closedAt(int x, int y) const;
  /// Velocity (cells/s) that the obstacle nearest to a cell has, or would have, at a point in cells.
  [[nodiscard]] glm::dvec2 velocityAt(glm::ivec2 cell, glm::dvec2 point) const;
  /// Whether some pocket has to grow or shrink: no side is open, and walls push or let in.
  [[nodiscard]] bool grows() const { return grows_; }
  /// Signed distance (cells) of cell (x, y)'s middle to the nearest obstacle and its number; at most 8.
  [[nodiscard]] double distanceAt(int x, int y) const { return shader::wallDistance(wordAt(x, y)); }

 private:
  struct Nearest;
  FluidSolids(const FluidParameters& p, Nearest nearest);
  [[nodiscard]] std::uint32_t& wordOf(int x, int y);
  void addDistances(const FluidParameters& p, const Nearest& nearest);
  void findSolid();
  void findPockets(glm::bvec2 wraps);
  void balance(const FluidParameters& p, const shader::FluidStep& sides);
  [[nodiscard]] std::size_t cell(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
  }
  /// Weights of a cell's left and top face (faceWeights); x and y up to the size.
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
