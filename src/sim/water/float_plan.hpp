#pragma once
#include "sim/core/shader_code.hpp"
#include "sim/water/hull.hpp"
#include "sim/water/parameters.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::shader {
#include "glsl/water/float_types.glsl"
static_assert(sizeof(FloatStep) == 96 && sizeof(FloatTold) == 16 * floatToldTexels);
}  // namespace simreel::shader

namespace simreel::sim {

/// What bodies that float are told; shared by the GPU simulation and its CPU twin.
class FloatPlan {
 public:
  FloatPlan() = default;
  /// The bodies of a water, whose name is of messages. Throws what Hull throws.
  [[nodiscard]] static std::vector<Hull> hullsOf(const WaterParameters& water, const std::string& object);
  /// In which these (s) lie on the ground as they should.
  [[nodiscard]] static double longestStep(const WaterParameters& water, const std::vector<Hull>& hulls);
  /// Seconds in which each stage of a reference level follows the one before (glsl/water/float_model.glsl).
  [[nodiscard]] static double followSeconds(const WaterParameters& water, double depth);
  /// `cells`: WaterPlan::firstCells(), or none, where first() is no matter; `depth`: the water's greatest
  /// (m). Throws usage for a body that reaches over too many cells.
  FloatPlan(const WaterParameters& water, const std::string& object, std::vector<Hull> hulls,
            double frameSeconds, int substeps, double depth, const std::vector<glm::vec4>& cells);

  [[nodiscard]] bool empty() const { return hulls_.empty(); }
  [[nodiscard]] const std::vector<Hull>& hulls() const { return hulls_; }
  /// Of each body in turn: Hull::points, and the probes and nodes of Hull::touched.
  [[nodiscard]] const std::vector<glm::vec4>& points() const { return points_; }
  /// floatTexels a body.
  [[nodiscard]] const std::vector<glm::vec4>& first() const { return first_; }
  [[nodiscard]] shader::FloatStep step() const { return step_; }
  /// What the frame that starts at `time` (s) is told: floatToldTexels a body.
  [[nodiscard]] std::vector<glm::vec4> toldAt(double time) const;
  /// Cells along a side of the largest window.
  [[nodiscard]] int side() const { return side_; }

 private:
  void describeStep(const WaterParameters& water, double dt, double depth);
  void warnIfWider(const WaterParameters& water, const std::string& name, std::size_t index) const;
  void addBody(const WaterParameters& water, const std::string& name, std::size_t index, double depth,
               const std::vector<glm::vec4>& cells);

  std::vector<WaterFloat> floats_;
  std::vector<Hull> hulls_;
  std::vector<glm::vec4> points_, first_;
  std::vector<shader::FloatTold> told_;
  shader::FloatStep step_{};
  double frameSeconds_ = 1;
  int side_ = 0;
};

}  // namespace simreel::sim
