#pragma once
#include "sim/mesh/height_plan.hpp"
#include "sim/water/plan.hpp"

#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of shallow water. It runs the kernels' own arithmetic (glsl/water compiled as C++). Equals the
/// GPU bit for bit in exact mode.
class WaterTwin {
 public:
  /// `start`: time of the first state in seconds.
  explicit WaterTwin(simreel::sim::WaterPlan plan, double start = 0);

  /// Steps one frame that starts at `time` (seconds).
  void step(double time);
  /// Moves the bed to `heights`, which have the layout of sim::HeightField, on the grid `grid`. If `fresh`
  /// is true, the level stays the same, as at the start of a run.
  void follow(const std::vector<glm::vec4>& heights, const simreel::shader::HeightGrid& grid, bool fresh);
  /// Computes one step without rain, strokes and drops.
  void advance(const simreel::shader::WaterStep& water);
  /// Returns the cells that glsl/water/look.comp computes for drawing.
  [[nodiscard]] std::vector<glm::vec4> look() const;
  [[nodiscard]] const simreel::sim::WaterPlan& plan() const { return plan_; }

  /// Moves the floats and computes the water that they displace. `index`: zero-based index of the step in
  /// the frame at `time` (seconds). If it is -1, only computes the water displaced in the first state.
  void drift(double time, int index);

  std::vector<glm::vec4> cells;       ///< one element per cell, x fastest
  std::vector<glm::vec4> floats;      ///< floats in the layout of FloatPlan::first()
  std::vector<glm::ivec4> displaced;  ///< displaced water, one element per cell; empty if there are no
                                      ///< floats

 private:
  void fall(double time, int step);

  simreel::sim::WaterPlan plan_;
  std::vector<glm::vec4> next_;
};
