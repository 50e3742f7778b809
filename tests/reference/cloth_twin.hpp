#pragma once
#include "reference/distance_twin.hpp"
#include "reference/walls_twin.hpp"
#include "reference/wind_twin.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/mesh/height_plan.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// The cloth on the CPU: the kernels' own model (glsl/cloth/model.glsl compiled as C++) in plain loops.
/// Equals the GPU bit for bit in exact mode.
class ClothTwin {
 public:
  explicit ClothTwin(simreel::sim::ClothPlan plan);

  /// One frame starting at `time` (s). `threads` 0: all processors.
  void step(double time, int threads = 1);
  /// One substep with the given data, the frame's number `index`.
  void substep(const simreel::shader::ClothStep& data, int threads = 1, int index = 0);
  /// The same in two halves, between which contact may change where the particles go.
  void predict(const simreel::shader::ClothStep& data, int threads = 1, int index = 0);
  void settle(const simreel::shader::ClothStep& data, int index = 0, bool again = true);
  void finish();

  std::vector<glm::vec4> positions;   ///< xyz m, w inverse mass
  std::vector<glm::vec4> velocities;  ///< xyz m/s, w pin group
  std::vector<glm::vec4> trends;      ///< xyz m/s, of constraints (glsl/cloth/motion.glsl)
  std::vector<glm::vec4> next;        ///< between predict() and finish(): where they go
  /// The mesh it falls onto; none without a plan.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4> heights;      ///< of the frame to step: x at its beginning, y at its end (m)
  std::optional<DistanceTwin> meshes;  ///< the rigid meshes they meet; none: no mesh
  std::optional<WallsTwin> walls;      ///< the solid it meets; none: no solid
  std::optional<WindTwin> wind;        ///< the fluid that is its wind; none: none blows
  [[nodiscard]] simreel::sim::ClothPlan& plan() { return plan_; }

 private:
  void constrain(const simreel::shader::ClothStep& data);
  void fend(const simreel::shader::ClothStep& data);

  simreel::sim::ClothPlan plan_;
  std::vector<glm::vec4> left_;  ///< where predict() left them
  std::vector<glm::vec4> ways_;  ///< of pins that follow a skin, in the frame
};
