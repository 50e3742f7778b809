#pragma once
#include "sim/water/plan.hpp"

#include <vector>

#include <glm/vec4.hpp>

/// Shallow water on the CPU: the kernels' own arithmetic (glsl/water compiled as C++). Equals the GPU bit
/// for bit in exact mode.
class WaterTwin {
 public:
  /// `start`: time (s) of the first state.
  explicit WaterTwin(simreel::sim::WaterPlan plan, double start = 0);

  /// One frame starting at `time` (s).
  void step(double time);
  /// One step and nothing that falls.
  void advance(const simreel::shader::WaterStep& water);
  /// What glsl/water/look.comp makes of each cell.
  [[nodiscard]] std::vector<glm::vec4> look() const;
  [[nodiscard]] const simreel::sim::WaterPlan& plan() const { return plan_; }

  /// Moves floats, and what they do to the water; step `index` of the frame at `time`, from 0. -1: what the
  /// first state's floats displace.
  void drift(double time, int index);

  std::vector<glm::vec4> cells;       ///< x fastest
  std::vector<glm::vec4> floats;      ///< FloatPlan::first()
  std::vector<glm::ivec4> displaced;  ///< a cell an element, as the kernels have it; empty without floats

 private:
  void fall(double time, int step);

  simreel::sim::WaterPlan plan_;
  std::vector<glm::vec4> next_;
};
