#pragma once
#include "sim/core/shader_code.hpp"
#include "sim/water/hull.hpp"
#include "sim/water/parameters.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::shader {
#include "glsl/water/float_types.glsl"
static_assert(sizeof(FloatStep) == 96 && sizeof(FloatParameters) == 16 * floatParameterTexels);
}  // namespace simreel::shader

namespace simreel::sim {

/// CPU-side setup of floating bodies. Used by the GPU simulation and by its CPU twin.
class FloatPlan {
 public:
  FloatPlan() = default;
  /// Builds the hulls of the bodies that float on a water. `object` is the name for messages. Throws the
  /// errors of Hull.
  [[nodiscard]] static std::vector<Hull> hullsOf(const WaterParameters& water, const std::string& object);
  /// Returns the maximum step in seconds for which bodies rest on the ground without sinking in too far.
  [[nodiscard]] static double longestStep(const WaterParameters& water, const std::vector<Hull>& hulls);
  /// Returns the time constant in seconds of each stage of the reference level's low-pass filter
  /// (glsl/water/float_model.glsl).
  [[nodiscard]] static double followSeconds(const WaterParameters& water, double depth);
  /// `cells` is WaterPlan::firstCells(), or empty if first() will not be used. `depth` is the maximum water
  /// depth in metres. Throws UserError(usage) for a body that covers too many cells.
  FloatPlan(const WaterParameters& water, const std::string& object, std::vector<Hull> hulls,
            double frameSeconds, int substeps, double depth, const std::vector<glm::vec4>& cells);

  [[nodiscard]] bool empty() const { return hulls_.empty(); }
  [[nodiscard]] const std::vector<Hull>& hulls() const { return hulls_; }
  /// Returns for each body, one after another: Hull::points, then the probes and the nodes of
  /// Hull::touched.
  [[nodiscard]] const std::vector<glm::vec4>& points() const { return points_; }
  /// Returns the initial state: floatTexels elements per body.
  [[nodiscard]] const std::vector<glm::vec4>& first() const { return first_; }
  [[nodiscard]] shader::FloatStep step() const { return step_; }
  /// Returns the bodies' parameters for the frame that starts at `time` (seconds): floatParameterTexels
  /// elements per body.
  [[nodiscard]] std::vector<glm::vec4> parametersAt(double time) const;
  /// Returns the width in cells of the largest window of cells under a body.
  [[nodiscard]] int side() const { return side_; }

 private:
  void describeStep(const WaterParameters& water, double dt, double depth);
  void warnIfWider(const WaterParameters& water, const std::string& name, std::size_t index) const;
  void addBody(const WaterParameters& water, const std::string& name, std::size_t index, double depth,
               const std::vector<glm::vec4>& cells);

  std::vector<WaterFloat> floats_;
  std::vector<Hull> hulls_;
  std::vector<glm::vec4> points_, first_;
  std::vector<shader::FloatParameters> parameters_;
  shader::FloatStep step_{};
  double frameSeconds_ = 1;
  int side_ = 0;
};

}  // namespace simreel::sim
