#pragma once
#include "sim/cloth_plan.hpp"

#include <vector>

#include <glm/vec4.hpp>

/// The cloth on the CPU: the kernels' own model (glsl/cloth/model.glsl compiled as C++) in plain loops.
/// Equals the GPU bit for bit in exact mode.
class ClothTwin {
 public:
  explicit ClothTwin(simreel::sim::ClothPlan plan);

  /// One frame starting at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  /// One substep with the given data.
  void substep(const simreel::shader::ClothStep& data, int threads = 1);

  std::vector<glm::vec4> positions;   ///< xyz m, w inverse mass
  std::vector<glm::vec4> velocities;  ///< xyz m/s, w pin group
  [[nodiscard]] simreel::sim::ClothPlan& plan() { return plan_; }

 private:
  void constrain(const simreel::shader::ClothStep& data);

  simreel::sim::ClothPlan plan_;
  std::vector<glm::vec4> next_;
};
