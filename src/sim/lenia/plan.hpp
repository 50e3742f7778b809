#pragma once
#include "sim/core/shader_code.hpp"
#include "sim/lenia/parameters.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// What a continuous automaton is told, worked out on the CPU. Shared with the twin.
class LeniaPlan {
 public:
  LeniaPlan(LeniaParameters parameters, const std::string& object, int seed, double frameSeconds);

  [[nodiscard]] const LeniaParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  /// Sums that a cell makes: one a kernel; of SmoothLife the ring's and the disc's.
  [[nodiscard]] int kernels() const;
  /// Cells that the widest kernel reaches, and in row `dy` of it.
  [[nodiscard]] int range() const { return range_; }
  [[nodiscard]] int reach(int dy) const;
  /// The weight of a cell `dx`, `dy` away in sum k; a kernel's add up to 1.
  [[nodiscard]] float weight(int k, int dx, int dy) const;
  /// All of them as glsl/lenia/step.comp wants them.
  [[nodiscard]] std::vector<glm::vec4> weights() const;
  /// mu, per sigma^2, weight and kind (glsl/lenia/model.glsl) of kernel k.
  [[nodiscard]] glm::vec4 growth(int k) const;
  [[nodiscard]] float dt() const { return static_cast<float>(1 / parameters_.timeScale); }
  [[nodiscard]] glm::vec4 limits() const;
  [[nodiscard]] glm::vec2 slopes() const;
  /// Four cells an element, rows of whole elements; spare ones are 0.
  [[nodiscard]] std::vector<glm::vec4> firstCells() const;
  [[nodiscard]] int rowItems() const { return (parameters_.size.x + 3) / 4; }

  [[nodiscard]] long frameAt(double time) const;
  /// Steps due by the start of a frame.
  [[nodiscard]] long stepAt(long frame) const;
  [[nodiscard]] int stepsPerFrame() const;
  [[nodiscard]] std::vector<shader::Stroke> strokesInto(long step) const;

 private:
  void makeWeights();

  LeniaParameters parameters_;
  int seed_;
  double frameSeconds_;
  int range_ = 0;
  std::vector<std::vector<double>> weights_;  ///< by kernel; rows of 2 range + 1
  Strokes strokes_;
};

}  // namespace simreel::sim
