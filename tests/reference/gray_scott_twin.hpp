#pragma once
#include "sim/gray_scott/plan.hpp"

#include <vector>

#include <glm/vec4.hpp>

/// Gray-Scott on the CPU: the kernels' arithmetic (glsl/gray_scott/model.glsl compiled as C++) in plain
/// loops over separate arrays of u and v, which the compiler vectorises. Equals the GPU bit for bit in
/// exact mode.
class GrayScottTwin {
 public:
  /// `start` is the time (s) of the first state.
  explicit GrayScottTwin(simreel::sim::GrayScottPlan plan, double start = 0);

  /// Simulates a frame that starts at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  /// Runs steps with the given rates and without strokes.
  void advance(const simreel::shader::GrayScottRates& rates, int steps, int threads = 1);

  /// Returns the state in the GPU's layout.
  [[nodiscard]] std::vector<glm::vec4> cells() const;
  [[nodiscard]] const simreel::sim::GrayScottPlan& plan() const { return plan_; }

  std::vector<float> u, v;  ///< concentrations, x varies fastest

 private:
  void rows(const simreel::shader::GrayScottRates& rates, int first, int last);
  void paint(const simreel::shader::Stroke& stroke);

  simreel::sim::GrayScottPlan plan_;
  glm::ivec2 size_;
  std::vector<float> nextU_, nextV_;
  std::vector<float> feedWeights_, killWeights_;  ///< empty unless the rates vary over the grid
};
