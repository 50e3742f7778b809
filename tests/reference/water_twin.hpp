#pragma once
#include "sim/water/plan.hpp"

#include <vector>

#include <glm/vec4.hpp>

/// Shallow water on the CPU: the kernels' arithmetic (glsl/water compiled as C++). Equals the GPU bit for
/// bit in exact mode.
class WaterTwin {
 public:
  /// `start` is the time (s) of the first state.
  explicit WaterTwin(simreel::sim::WaterPlan plan, double start = 0);

  /// Simulates a frame that starts at `time` (s).
  void step(double time);
  /// Simulates one step without drops, sources or strokes.
  void advance(const simreel::shader::WaterStep& water);
  /// Returns the result of glsl/water/look.comp for each cell.
  [[nodiscard]] std::vector<glm::vec4> look() const;
  [[nodiscard]] const simreel::sim::WaterPlan& plan() const { return plan_; }

  /// Moves floats and applies their effect on the water in step `index` (zero-based) of the frame at
  /// `time`. -1: computes the displacement in the first state.
  void drift(double time, int index);

  std::vector<glm::vec4> cells;   ///< state of each cell, x varies fastest
  std::vector<glm::vec4> floats;  ///< floating bodies in the layout of FloatPlan::first()
  /// water displaced by floats, one element per cell in the kernels' layout; empty without floats
  std::vector<glm::ivec4> displaced;

 private:
  void fall(double time, int step);

  simreel::sim::WaterPlan plan_;
  std::vector<glm::vec4> next_;
};
