#pragma once
#include "gl/element_array.hpp"
#include "sim/cave/corridors.hpp"
#include "sim/cave/parameters.hpp"
#include "sim/cave/regions.hpp"
#include "sim/cave/waves.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// What there is to find in a finished cave, in cells.
struct CaveWay {
  unsigned entrance = noCell, exit = noCell;  ///< numbers of cells; noCell: nothing is open
  std::vector<glm::ivec2> path;               ///< from the entrance to the exit
  std::vector<glm::dvec2> walk;               ///< the same, smooth
};

struct CaveSmooth;

/// The automaton on the GPU: its cells, stage by stage, and what is found in them in the end.
class CaveGrowth {
 public:
  CaveGrowth(const std::string& name, const CaveParameters& parameters, int seed);

  /// Goes on to a stage, which is none before the present one.
  void advance(int stage);
  /// After cells and stage were put back.
  void restored() { findWay(); }

  [[nodiscard]] int stage() const { return stage_; }
  [[nodiscard]] bool done() const { return stage_ == parameters_.lastStage(); }
  [[nodiscard]] const CaveGrid& grid() const { return grid_; }
  /// A bit a cell, 1 rock (glsl/cave/cells.glsl).
  [[nodiscard]] const gl::WordsArray& cells() const { return cells_[0]; }
  /// 32-bit floats, one for each number of a cell: steps from the entrance, -1 where nobody gets.
  [[nodiscard]] const gl::WordsArray& distances() const { return distances_; }
  [[nodiscard]] const CaveWay& way() const { return way_; }
  /// Those that corridors join, or before that those there are. Reads back; waits for the GPU.
  [[nodiscard]] std::vector<Room> rooms() const;
  void carryOver(CarryOver& carry);

 private:
  void fill(int seed);
  void smooth();
  void clean();
  void connect();
  void findWay();

  std::string name_;
  CaveParameters parameters_;
  CaveGrid grid_;
  int stage_ = 0;
  gl::WordsArray cells_[2];
  gl::WordsArray roomCells_;  ///< before corridors
  gl::WordsArray distances_;
  gl::Kernel<CaveSmooth> smooth_;
  CaveRegions regions_;
  std::optional<CaveCorridors> corridors_;
  CaveWaves waves_;
  CaveWay way_;
};

}  // namespace simreel::sim
