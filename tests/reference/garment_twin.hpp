#pragma once
#include "reference/distance_twin.hpp"
#include "reference/walls_twin.hpp"
#include "reference/wind_twin.hpp"
#include "sim/garment/plan.hpp"
#include "sim/mesh/height_plan.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// Cloth of a mesh on the CPU: the kernels' own model (glsl/garment compiled as C++) in plain loops.
/// Equals the GPU bit for bit in exact mode.
class GarmentTwin {
 public:
  explicit GarmentTwin(simreel::sim::GarmentPlan plan);

  /// One frame starting at `time` (s).
  void step(double time);
  /// One substep with the given data, the frame's number `index`.
  void substep(const simreel::shader::ClothStep& data, int index = 0);
  /// Normals of the cloth's vertices.
  [[nodiscard]] std::vector<glm::vec3> normals() const;

  std::vector<glm::vec4> positions;   ///< xyz m, w inverse mass
  std::vector<glm::vec4> velocities;  ///< xyz m/s, w pin group
  std::vector<glm::vec4> trends;      ///< xyz m/s; of what is pinned where it is at rest (m)
  /// The mesh it falls onto; none without a plan.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4> heights;      ///< of the frame to step: x at its beginning, y at its end (m)
  std::optional<DistanceTwin> meshes;  ///< the rigid meshes they meet; none: no mesh
  std::optional<WallsTwin> walls;      ///< the solid it meets; none: no solid
  std::optional<WindTwin> wind;        ///< the fluid that is its wind; none: none blows
  [[nodiscard]] simreel::sim::GarmentPlan& plan() { return plan_; }

 private:
  void fend(const simreel::shader::ClothStep& data);
  simreel::sim::GarmentPlan plan_;
  std::vector<glm::vec4> next_, forces_;
  std::vector<glm::vec4> ways_;  ///< of pins that follow a skin, in the frame
};
