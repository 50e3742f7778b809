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
// After the types.
#include "glsl/water/look_types.glsl"
#include "glsl/water/model.glsl"
static_assert(sizeof(WaterStep) == 80 && sizeof(WaterLook) == 48);
#undef precise
#undef FUNCTION
}  // namespace simreel::shader

namespace simreel::sim {

/// What falls in as one step ends.
struct WaterFalls {
  std::vector<shader::Stroke> strokes;
  std::vector<shader::WaterDrop> drops;
};

/// Everything of the water that is decided on the CPU; shared by the GPU simulation and its CPU twin.
class WaterPlan {
 public:
  /// Reads the images. Throws UserError for one that cannot be read and usage where no number of substeps
  /// is enough. Warns where `substeps` are too few for the greatest depth and speed.
  WaterPlan(WaterParameters parameters, const std::string& object, int seed, double frameSeconds)
      : WaterPlan(std::move(parameters), object, seed, frameSeconds, true) {}
  /// The same without firstCells(), for looking for mistakes: of a grid that takes gigabytes, whose
  /// substeps then are no matter.
  [[nodiscard]] static WaterPlan withoutCells(WaterParameters parameters, const std::string& object,
                                              int seed, double frameSeconds) {
    return {std::move(parameters), object, seed, frameSeconds, false};
  }

  /// A cell an element, x fastest: level (m), discharges along x and z (m^2/s, zero), bed (m).
  [[nodiscard]] const std::vector<glm::vec4>& firstCells() const { return first_; }
  [[nodiscard]] int substeps() const { return substeps_; }
  [[nodiscard]] double stepSeconds() const { return frameSeconds_ / substeps_; }
  /// What the steps of the frame that starts at `time` (s) are told; `step` counts from 0, and matters
  /// where waves come in alone.
  [[nodiscard]] shader::WaterStep stepAt(double time, int step = 0) const;
  /// How many of them differ: one, or each.
  [[nodiscard]] int toldSteps() const { return parameters_.swell.empty() ? 1 : substeps_; }
  /// What falls into the state after `step` steps of the frame that starts at `time` (s).
  [[nodiscard]] WaterFalls fallsAt(double time, int step) const;
  /// Cells that a drop may reach: as Strokes::box.
  [[nodiscard]] glm::ivec4 box(const shader::WaterDrop& drop) const;
  [[nodiscard]] bool anythingFalls() const;
  [[nodiscard]] const FloatPlan& floats() const { return floats_; }

  [[nodiscard]] const WaterParameters& parameters() const { return parameters_; }
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }
  [[nodiscard]] shader::WaterLook look() const;
  /// Linear RGB by the number that a vertex has in w.
  [[nodiscard]] std::vector<glm::vec4> palette() const;
  /// Metres from the grid's middle to cells.
  [[nodiscard]] glm::dvec2 cellsAt(const glm::vec3& metres) const;

 private:
  WaterPlan(WaterParameters parameters, const std::string& object, int seed, double frameSeconds,
            bool cells);
  [[nodiscard]] std::vector<float> bedHeights() const;
  void makeFirst();
  [[nodiscard]] double deepestPossible() const;
  /// `longest` (s) that a step may be for floats.
  void chooseSubsteps(const std::string& object, double longest);
  [[nodiscard]] shader::WaterDrop dropOf(glm::dvec2 center, double radius, float height) const;

  WaterParameters parameters_;
  int seed_;
  double frameSeconds_;
  int substeps_ = 1;
  double depth_ = 1;  ///< m, the greatest
  std::vector<glm::vec4> first_;
  Strokes strokes_;
  FloatPlan floats_;
};

}  // namespace simreel::sim
