#pragma once
#include "sim/life/plan.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

/// A generation of any rule on any grid, by plain loops over neighbours: what it is, written so that it can
/// be checked by reading. A byte a cell, rows without gaps.
std::vector<std::uint8_t> nextStates(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                                     const simreel::sim::CellRule& rule,
                                     const simreel::sim::GridShape& shape);

/// Of one cell of it.
std::uint8_t nextState(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                       const simreel::sim::CellRule& rule, const simreel::sim::GridShape& shape,
                       glm::ivec2 at);

/// An automaton of several states on the CPU.
class StatesTwin {
 public:
  /// `start`: time (s) of the first state.
  explicit StatesTwin(simreel::sim::LifePlan plan, double start = 0);
  /// One frame starting at `time` (s).
  void step(double time);
  /// As the GPU has them: rows of whole blocks of 16.
  [[nodiscard]] std::vector<std::uint8_t> rows() const;

  std::vector<std::uint8_t> cells;  ///< rows without gaps

 private:
  void paint(long generation);
  simreel::sim::LifePlan plan_;
};
