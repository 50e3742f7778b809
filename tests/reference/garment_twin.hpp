#pragma once
#include "reference/distance_twin.hpp"
#include "reference/walls_twin.hpp"
#include "reference/wind_twin.hpp"
#include "sim/garment/plan.hpp"
#include "sim/mesh/height_plan.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// Cloth of a mesh on the CPU: the kernels' model (glsl/garment compiled as C++) in plain loops. Equals the
/// GPU bit for bit in exact mode.
class GarmentTwin {
 public:
  explicit GarmentTwin(simreel::sim::GarmentPlan plan);

  /// Simulates a frame that starts at `time` (s).
  void step(double time);
  /// Simulates a substep with the given data; `index` is its number within the frame.
  void substep(const simreel::shader::ClothStep& data, int index = 0);
  /// Returns the normals of the cloth's vertices.
  [[nodiscard]] std::vector<glm::vec3> normals() const;

  std::vector<glm::vec4> positions;   ///< position (xyz, m) and inverse mass (w) of each vertex
  std::vector<glm::vec4> velocities;  ///< velocity (xyz, m/s) and pin group (w) of each vertex
  /// velocity change by constraints (xyz, m/s); for pinned vertices the rest position (m)
  std::vector<glm::vec4> trends;
  /// The height map that the cloth falls onto; empty without one.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4>
      heights;  ///< heights of the mesh (m) for the current frame: x at its start, y at its end
  std::optional<DistanceTwin> meshes;  ///< rigid meshes that collide with the cloth; empty without any
  std::optional<WallsTwin> walls;      ///< solid that collides with the cloth; empty without one
  std::optional<WindTwin> wind;        ///< fluid that blows on the cloth; empty without one
  [[nodiscard]] simreel::sim::GarmentPlan& plan() { return plan_; }

 private:
  void fend(const simreel::shader::ClothStep& data);
  simreel::sim::GarmentPlan plan_;
  std::vector<glm::vec4> next_, forces_;
  std::vector<glm::vec4> ways_;  ///< motion of skin-bound pins during the frame
};
