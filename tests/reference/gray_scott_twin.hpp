#pragma once
#include "sim/gray_scott/plan.hpp"

#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of Gray-Scott. It runs the kernels' own arithmetic (glsl/gray_scott/model.glsl compiled as C++)
/// in plain loops over separate arrays of u and v, so that the compiler vectorizes the loops. Equals the
/// GPU bit for bit in exact mode.
class GrayScottTwin {
 public:
  /// `start`: time of the first state in seconds.
  explicit GrayScottTwin(simreel::sim::GrayScottPlan plan, double start = 0);

  /// Steps one frame that starts at `time` (seconds). `threads`: number of threads; 0 to use all
  /// processors.
  void step(double time, int threads = 1);
  /// Runs steps with the given rates and without strokes.
  void advance(const simreel::shader::GrayScottRates& rates, int steps, int threads = 1);

  /// Returns the state in the GPU's memory layout.
  [[nodiscard]] std::vector<glm::vec4> cells() const;
  [[nodiscard]] const simreel::sim::GrayScottPlan& plan() const { return plan_; }

  std::vector<float> u, v;  ///< one value per cell, x fastest

 private:
  void rows(const simreel::shader::GrayScottRates& rates, int first, int last);
  void paint(const simreel::shader::Stroke& stroke);

  simreel::sim::GrayScottPlan plan_;
  glm::ivec2 size_;
  std::vector<float> nextU_, nextV_;
  std::vector<float> feedWeights_, killWeights_;  ///< weights per cell; empty if the rates are the same in
                                                  ///< all cells
};
