#pragma once
#include "sim/life/plan.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

/// Computes a generation of any rule on any grid by plain loops over neighbours, so that it can be verified
/// by reading. One byte per cell, rows without gaps.
std::vector<std::uint8_t> nextStates(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                                     const simreel::sim::CellRule& rule,
                                     const simreel::sim::GridShape& shape);

/// Returns the next state of one cell.
std::uint8_t nextState(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                       const simreel::sim::CellRule& rule, const simreel::sim::GridShape& shape,
                       glm::ivec2 at);

/// An automaton with several states on the CPU.
class StatesTwin {
 public:
  /// `start` is the time (s) of the first state.
  explicit StatesTwin(simreel::sim::LifePlan plan, double start = 0);
  /// Simulates a frame that starts at `time` (s).
  void step(double time);
  /// Returns the cells in the GPU's layout: rows of whole blocks of 16.
  [[nodiscard]] std::vector<std::uint8_t> rows() const;

  std::vector<std::uint8_t> cells;  ///< cell states, rows without gaps

 private:
  void paint(long generation);
  simreel::sim::LifePlan plan_;
};
