#pragma once
#include "sim/cave/parameters.hpp"

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

/// The cave automaton on the CPU, in plain loops over cells: queues, sorted edges and counted neighbours
/// where the kernels have labels, minima and adders. Equals the GPU bit for bit.
class CaveTwin {
 public:
  CaveTwin(const simreel::sim::CaveParameters& parameters, int seed);

  void smooth();
  /// Small rooms, then small rock.
  void clean();
  void connect();
  /// Everything there is.
  void finish();

  [[nodiscard]] bool isRock(int x, int y) const {
    return x < 0 || y < 0 || x >= size_.x || y >= size_.y || rock[index(x, y)];
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
  }
  /// The lowest cell of the region that each cell of that kind is in, -1 for others; a region's number is
  /// where its cell comes in the map, row by row.
  [[nodiscard]] std::vector<int> regions(bool ofRock) const;
  /// Steps from an open cell to each, -1 where there is no way.
  [[nodiscard]] std::vector<int> distancesFrom(glm::ivec2 start) const;
  /// Entrance and exit; nothing when no cell is open.
  [[nodiscard]] std::optional<std::pair<glm::ivec2, glm::ivec2>> ends() const;
  /// Lengths of the corridors that connect() would dig, summed.
  [[nodiscard]] long corridorLength() const;
  /// As the GPU holds them.
  [[nodiscard]] std::vector<glm::uvec4> words() const;

  std::vector<bool> rock;  ///< x fastest

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
  glm::ivec2 size_;
};
