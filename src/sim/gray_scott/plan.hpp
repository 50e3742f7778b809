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

/// CPU-side setup of a Gray-Scott field: the initial state, the map of rates, and the parameters of each
/// frame. Used by the GPU simulation and by its CPU twin.
class GrayScottPlan {
 public:
  /// Reads the images. Throws UserError if an image cannot be read.
  GrayScottPlan(GrayScottParameters parameters, const std::string& object, int seed, double frameSeconds);
  /// Reads the images that the parameters name, to detect errors. Throws the errors of loadPicture.
  void checkPictures() const;

  /// Returns the initial state: two cells (u, v, u, v) per element, in rows of columns() elements. If the
  /// width is odd, the unused half element of a row repeats cell 0.
  [[nodiscard]] std::vector<glm::vec4> firstCells() const;
  /// Returns true if the rates vary over the grid.
  [[nodiscard]] bool mapped() const;
  /// Returns the interpolation weights of the rates, (feed, kill, feed, kill) per element in the layout of
  /// firstCells(); empty unless mapped() is true.
  [[nodiscard]] std::vector<glm::vec4> weights() const;
  /// Returns the rates for the frame that starts at `time` (seconds).
  [[nodiscard]] shader::GrayScottRates ratesAt(double time) const;
  /// Returns the strokes that paint into the state after `step` steps of the frame that starts at `time`
  /// (seconds).
  [[nodiscard]] std::vector<shader::Stroke> strokesAt(double time, int step) const;

  /// Adopts new values of the rates that do not vary in space.
  void retune(const GrayScottParameters& now);

  [[nodiscard]] const GrayScottParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  [[nodiscard]] int columns() const { return (parameters_.size.x + 1) / 2; }

 private:
  /// Returns v of each cell of the initial state, 0 to 1.
  [[nodiscard]] std::vector<float> firstV() const;

  GrayScottParameters parameters_;
  int seed_;
  double frameSeconds_;
  Strokes strokes_;
};

}  // namespace simreel::sim
