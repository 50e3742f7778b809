#pragma once
#include "sim/gray_scott/plan.hpp"

#include <vector>

#include <glm/vec4.hpp>

/// Gray-Scott on the CPU: the kernels' own arithmetic (glsl/gray_scott/model.glsl compiled as C++) in plain
/// loops over u and v apart, which the compiler turns into vectors. Equals the GPU bit for bit in exact
/// mode.
class GrayScottTwin {
 public:
  /// `start`: time (s) of the first state.
  explicit GrayScottTwin(simreel::sim::GrayScottPlan plan, double start = 0);

  /// One frame starting at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  /// Steps with given rates and no strokes.
  void advance(const simreel::shader::GrayScottRates& rates, int steps, int threads = 1);

  /// The state as the GPU holds it.
  [[nodiscard]] std::vector<glm::vec4> cells() const;
  [[nodiscard]] const simreel::sim::GrayScottPlan& plan() const { return plan_; }

  std::vector<float> u, v;  ///< x fastest

 private:
  void rows(const simreel::shader::GrayScottRates& rates, int first, int last);
  void paint(const simreel::shader::Stroke& stroke);

  simreel::sim::GrayScottPlan plan_;
  glm::ivec2 size_;
  std::vector<float> nextU_, nextV_;
  std::vector<float> feedWeights_, killWeights_;  ///< empty unless the rates vary over the grid
};
