#pragma once
#include "sim/life/plan.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

/// Returns the next generation of any rule on any grid by plain loops over neighbours, which are simple
/// enough to check by reading. Uses one byte per cell and rows without padding.
std::vector<std::uint8_t> nextStates(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                                     const simreel::sim::CellRule& rule,
                                     const simreel::sim::GridShape& shape);

/// Returns the next state of the cell at position `at`.
std::uint8_t nextState(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                       const simreel::sim::CellRule& rule, const simreel::sim::GridShape& shape,
                       glm::ivec2 at);

/// CPU twin of an automaton with several states.
class StatesTwin {
 public:
  /// `start`: time of the first state in seconds.
  explicit StatesTwin(simreel::sim::LifePlan plan, double start = 0);
  /// Steps one frame that starts at `time` (seconds).
  void step(double time);
  /// Returns the cells in the GPU's memory layout, in which rows are padded to blocks of 16 cells.
  [[nodiscard]] std::vector<std::uint8_t> rows() const;

  std::vector<std::uint8_t> cells;  ///< one byte per cell; rows have no padding

 private:
  void paint(long generation);
  simreel::sim::LifePlan plan_;
};
