#pragma once
#include "sim/core/shader_code.hpp"
#include "sim/lenia/parameters.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// The part of a continuous automaton that the CPU computes. The GPU simulation and its CPU reference both
/// use it.
class LeniaPlan {
 public:
  LeniaPlan(LeniaParameters parameters, const std::string& object, int seed, double frameSeconds);

  [[nodiscard]] const LeniaParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  /// Returns the number of weighted sums per cell: one per kernel, or for SmoothLife two (ring and disc).
  [[nodiscard]] int kernels() const;
  /// range() returns the radius in cells of the widest kernel. reach() returns the half-width of the
  /// kernel's row `dy`.
  [[nodiscard]] int range() const { return range_; }
  [[nodiscard]] int reach(int dy) const;
  /// Returns the weight in sum k of a cell at the offset (dx, dy). The weights of a kernel add up to 1.
  [[nodiscard]] float weight(int k, int dx, int dy) const;
  /// Returns all weights in the layout of glsl/lenia/step.comp.
  [[nodiscard]] std::vector<glm::vec4> weights() const;
  /// Returns the growth function of kernel k (glsl/lenia/model.glsl): x mu; y 1 / (9 sigma^2), 1 / (2
  /// sigma^2) or sigma, depending on the function's kind; z weight; w kind of the function.
  [[nodiscard]] glm::vec4 growth(int k) const;
  [[nodiscard]] float dt() const { return static_cast<float>(1 / parameters_.timeScale); }
  [[nodiscard]] glm::vec4 limits() const;
  [[nodiscard]] glm::vec2 slopes() const;
  /// Returns the initial state with four cells per element. Rows are padded with zeros to whole elements.
  [[nodiscard]] std::vector<glm::vec4> firstCells() const;
  [[nodiscard]] int rowItems() const { return (parameters_.size.x + 3) / 4; }

  [[nodiscard]] long frameAt(double time) const;
  /// Returns the number of steps that must be complete at the start of a frame.
  [[nodiscard]] long stepAt(long frame) const;
  [[nodiscard]] int stepsPerFrame() const;
  [[nodiscard]] std::vector<shader::Stroke> strokesInto(long step) const;

 private:
  void makeWeights();

  LeniaParameters parameters_;
  int seed_;
  double frameSeconds_;
  int range_ = 0;
  std::vector<std::vector<double>> weights_;  ///< weights of each kernel, in rows of 2 range + 1 weights
  Strokes strokes_;
};

}  // namespace simreel::sim
