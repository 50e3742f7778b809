#pragma once
#include "sim/cave/parameters.hpp"

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

/// CPU twin of the cave automaton, in plain loops over cells. It uses queues, sorted edges and neighbour
/// counts instead of the kernels' labels, minima and bitwise adders. Equals the GPU bit for bit.
class CaveTwin {
 public:
  CaveTwin(const simreel::sim::CaveParameters& parameters, int seed);

  void smooth();
  /// Removes small rooms, then small rock islands.
  void clean();
  void connect();
  /// Runs all remaining stages.
  void finish();

  [[nodiscard]] bool isRock(int x, int y) const {
    return x < 0 || y < 0 || x >= size_.x || y >= size_.y || rock[index(x, y)];
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
  }
  /// Returns, for each cell, the lowest cell index (row by row) in the cell's region, or -1 for cells of
  /// the other kind. `ofRock`: true for regions of rock, false for open regions.
  [[nodiscard]] std::vector<int> regions(bool ofRock) const;
  /// Returns the number of steps from an open cell to each cell, or -1 for an unreachable cell.
  [[nodiscard]] std::vector<int> distancesFrom(glm::ivec2 start) const;
  /// Returns entrance and exit, or nullopt if no cell is open.
  [[nodiscard]] std::optional<std::pair<glm::ivec2, glm::ivec2>> ends() const;
  /// Returns the total length of the corridors that connect() would dig.
  [[nodiscard]] long corridorLength() const;
  /// Returns the value of each cell between the stage with the cells `before` and the current one.
  [[nodiscard]] std::vector<float> blended(const std::vector<bool>& before, float fraction) const;
  /// Returns the cells in the GPU's memory layout.
  [[nodiscard]] std::vector<glm::uvec4> words() const;

  std::vector<bool> rock;  ///< true for rock; cell by cell, x fastest

 private:
  struct Corridor {
    long length;
    glm::ivec2 from, to;
  };
  void remove(bool ofRock, int fewest);
  [[nodiscard]] std::vector<int> nearestOpen() const;
  [[nodiscard]] std::vector<Corridor> corridors() const;
  void dig(const Corridor& corridor);
  [[nodiscard]] glm::ivec2 farthest(const std::vector<int>& distances) const;

  simreel::sim::CaveParameters parameters_;
  int seed_;
  glm::ivec2 size_;
};
