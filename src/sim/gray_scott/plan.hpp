#pragma once
#include "sim/core/shader_code.hpp"
#include "sim/gray_scott/parameters.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::shader {
#define FUNCTION inline
#define precise
#include "glsl/gray_scott/model.glsl"
static_assert(sizeof(GrayScottRates) == 32);
#undef precise
#undef FUNCTION
}  // namespace simreel::shader

namespace simreel::sim {

/// Everything of a Gray-Scott field that is decided on the CPU: the first state, the map of rates, and what
/// each frame is told. Shared by the GPU simulation and its CPU twin.
class GrayScottPlan {
 public:
  /// Reads the images. Throws UserError for one that cannot be read.
  GrayScottPlan(GrayScottParameters parameters, const std::string& object, int seed, double frameSeconds);
  /// Reads the pictures that the parameters name. Throws UserError: what loadPicture says.
  void checkPictures() const;

  /// Two cells (u, v, u, v) an element, rows of columns() elements; the spare half of an odd row is cell 0.
  [[nodiscard]] std::vector<glm::vec4> firstCells() const;
  /// Whether the rates vary over the grid.
  [[nodiscard]] bool mapped() const;
  /// Weights of the rates, (feed, kill, feed, kill) an element as firstCells(); empty unless mapped().
  [[nodiscard]] std::vector<glm::vec4> weights() const;
  /// Of the frame that starts at `time` (s).
  [[nodiscard]] shader::GrayScottRates ratesAt(double time) const;
  /// Strokes that paint into the state after `step` steps of the frame that starts at `time` (s).
  [[nodiscard]] std::vector<shader::Stroke> strokesAt(double time, int step) const;

  /// Takes over the rates that do not vary in space.
  void retune(const GrayScottParameters& now);

  [[nodiscard]] const GrayScottParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  [[nodiscard]] int columns() const { return (parameters_.size.x + 1) / 2; }

 private:
  /// v of a cell of the first state. 0 to 1.
  [[nodiscard]] std::vector<float> firstV() const;

  GrayScottParameters parameters_;
  int seed_;
  double frameSeconds_;
  Strokes strokes_;
};

}  // namespace simreel::sim
