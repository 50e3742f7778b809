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

/// Path through a finished cave, in cells.
struct CaveWay {
  unsigned entrance = noCell,
           exit = noCell;        ///< Cell indices of the path's ends; noCell if there is no open cell.
  std::vector<glm::ivec2> path;  ///< Cells of the path from the entrance to the exit.
  std::vector<glm::dvec2> walk;  ///< Smoothed path from the entrance to the exit, in cells.
};

struct CaveSmooth;
struct CaveBlend;

/// Runs the cellular automaton on the GPU. Provides the cells of the current stage and the path in the
/// finished cave.
class CaveGrowth {
 public:
  CaveGrowth(const std::string& name, const CaveParameters& parameters, int seed);

  /// Advances to a stage, which must not precede the current one.
  void advance(int stage);
  /// Call it after cells and stage were restored from a checkpoint. Finds the path again.
  void restored() { findWay(); }

  [[nodiscard]] int stage() const { return stage_; }
  [[nodiscard]] bool done() const { return stage_ == parameters_.lastStage(); }
  [[nodiscard]] const CaveGrid& grid() const { return grid_; }
  /// Returns the cells, one bit per cell, 1 for rock (glsl/cave/cells.glsl).
  [[nodiscard]] const gl::WordsArray& cells() const { return cells_[0]; }
  /// Mixes the cells of the stage before with the current ones: `fraction` 0 gives the stage before, 1 the
  /// current one. Only for caves that move between stages (CaveParameters::moves).
  void blend(float fraction);
  /// Returns the result of the last blend(): one 32-bit float per cell index, 1 for rock, 0 for open cells.
  [[nodiscard]] const gl::WordsArray& blended() const { return blended_; }
  /// Returns one 32-bit float per cell index: the number of steps from the entrance, or -1 for unreachable
  /// cells.
  [[nodiscard]] const gl::WordsArray& distances() const { return distances_; }
  [[nodiscard]] const CaveWay& way() const { return way_; }
  /// Returns the rooms that corridors connect. In an unfinished cave, these are the current rooms. Reads
  /// back data and waits for the GPU.
  [[nodiscard]] std::vector<Room> rooms() const;
  void visitCheckpointData(CarryOver& carry);

 private:
  void fill();
  void smooth();
  void clean();
  void connect();
  void findWay();

  std::string name_;
  CaveParameters parameters_;
  CaveGrid grid_;
  unsigned seed_;
  int stage_ = 0;
  gl::WordsArray cells_[2];   ///< Cells of the current stage and, if the cave moves, of the stage before.
  gl::WordsArray roomCells_;  ///< Copy of the cells before corridors are dug.
  gl::WordsArray distances_, blended_;
  gl::Kernel<CaveSmooth> smooth_;
  gl::Kernel<CaveBlend> blend_;
  CaveRegions regions_;
  std::optional<CaveCorridors> corridors_;
  CaveWaves waves_;
  CaveWay way_;
};

}  // namespace simreel::sim
