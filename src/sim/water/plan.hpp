#pragma once
#include "sim/core/shader_code.hpp"
#include "sim/water/float_plan.hpp"
#include "sim/water/parameters.hpp"

#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::shader {
#define FUNCTION inline
#define precise
#include "glsl/water/types.glsl"
// The headers below need the types of types.glsl.
#include "glsl/water/look_types.glsl"
#include "glsl/water/model.glsl"
static_assert(sizeof(WaterStep) == 80 && sizeof(WaterLook) == 48);
#undef precise
#undef FUNCTION
}  // namespace simreel::shader

namespace simreel::sim {

/// Strokes and drops applied to the water at the end of one step.
struct WaterFalls {
  std::vector<shader::Stroke> strokes;
  std::vector<shader::WaterDrop> drops;
};

/// CPU-side setup of the water. Used by the GPU simulation and by its CPU twin.
class WaterPlan {
 public:
  /// Reads the images. Throws UserError if an image cannot be read, and UserError(usage) if no allowed
  /// number of substeps suffices. Warns if `substeps` is too small for the maximum depth and speed.
  WaterPlan(WaterParameters parameters, const std::string& object, int seed, double frameSeconds)
      : WaterPlan(std::move(parameters), object, seed, frameSeconds, true) {}
  /// Creates a plan without firstCells(), for validating grids whose arrays would take gigabytes. Its
  /// number of substeps is not meaningful.
  [[nodiscard]] static WaterPlan withoutCells(WaterParameters parameters, const std::string& object,
                                              int seed, double frameSeconds) {
    return {std::move(parameters), object, seed, frameSeconds, false};
  }

  /// Returns the initial state with one element per cell, x fastest: level (m), discharge along x and along
  /// z (m^2/s, zero), bed height (m).
  [[nodiscard]] const std::vector<glm::vec4>& firstCells() const { return first_; }
  [[nodiscard]] int substeps() const { return substeps_; }
  [[nodiscard]] double stepSeconds() const { return frameSeconds_ / substeps_; }
  /// Returns the step parameters of the frame that starts at `time` (seconds). `step` is the zero-based
  /// step, which matters only if there is swell.
  [[nodiscard]] shader::WaterStep stepAt(double time, int step = 0) const;
  /// Returns the number of different step parameter blocks per frame: one per substep if there is swell,
  /// otherwise one.
  [[nodiscard]] int uniformSteps() const { return parameters_.swell.empty() ? 1 : substeps_; }
  /// Returns the drops and strokes applied to the state after `step` steps of the frame that starts at
  /// `time` (seconds).
  [[nodiscard]] WaterFalls fallsAt(double time, int step) const;
  /// Returns the cells that a drop may affect, in the format of Strokes::box.
  [[nodiscard]] glm::ivec4 box(const shader::WaterDrop& drop) const;
  [[nodiscard]] bool anythingFalls() const;
  [[nodiscard]] const FloatPlan& floats() const { return floats_; }

  [[nodiscard]] const WaterParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  [[nodiscard]] shader::WaterLook look() const;
  /// Returns linear RGB colours that are indexed by w of a vertex.
  [[nodiscard]] std::vector<glm::vec4> palette() const;
  /// Converts metres relative to the grid's centre to cell coordinates.
  [[nodiscard]] glm::dvec2 cellsAt(const glm::vec3& metres) const;

 private:
  WaterPlan(WaterParameters parameters, const std::string& object, int seed, double frameSeconds,
            bool cells);
  [[nodiscard]] std::vector<float> bedHeights() const;
  void makeFirst();
  [[nodiscard]] double deepestPossible() const;
  /// `longest` is the maximum step in seconds that the floating bodies allow.
  void chooseSubsteps(const std::string& object, double longest);
  /// Appends the rain's drops that fall into the state at `now` (seconds), after `step` steps of its frame.
  void rainInto(std::vector<shader::WaterDrop>& drops, double now, int step) const;
  [[nodiscard]] shader::WaterDrop dropOf(glm::dvec2 center, double radius, float height) const;

  WaterParameters parameters_;
  int seed_;
  double frameSeconds_;
  int substeps_ = 1;
  double depth_ = 1;  ///< Maximum depth of the water in metres.
  std::vector<glm::vec4> first_;
  Strokes strokes_;
  FloatPlan floats_;
};

}  // namespace simreel::sim
