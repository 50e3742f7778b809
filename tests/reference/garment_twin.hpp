#pragma once
#include "reference/distance_twin.hpp"
#include "reference/walls_twin.hpp"
#include "reference/wind_twin.hpp"
#include "sim/garment/plan.hpp"
#include "sim/mesh/height_plan.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of mesh cloth: the kernels' own model (glsl/garment compiled as C++) in plain loops. Equals the
/// GPU bit for bit in exact mode.
class GarmentTwin {
 public:
  explicit GarmentTwin(simreel::sim::GarmentPlan plan);

  /// Steps one frame that starts at `time` (seconds).
  void step(double time);
  /// Steps one substep with the given data; `index` is the substep's number in the frame.
  void substep(const simreel::shader::ClothStep& data, int index = 0);
  /// Returns the normals of the cloth's vertices.
  [[nodiscard]] std::vector<glm::vec3> normals() const;

  std::vector<glm::vec4> positions;   ///< xyz in metres, w inverse mass
  std::vector<glm::vec4> velocities;  ///< xyz in m/s, w pin group
  std::vector<glm::vec4> trends;      ///< xyz in m/s; for pinned vertices the rest position in metres
  /// The deformed mesh that the cloth may touch, if any.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4> heights;      ///< mesh heights in metres: x frame start, y frame end
  std::optional<DistanceTwin> meshes;  ///< the rigid meshes that the cloth may touch, if any
  std::optional<WallsTwin> walls;      ///< the solid that the cloth may touch, if any
  std::optional<WindTwin> wind;        ///< the fluid whose wind acts on the cloth, if any
  [[nodiscard]] simreel::sim::GarmentPlan& plan() { return plan_; }

 private:
  void resolveThin(const simreel::shader::ClothStep& data);
  simreel::sim::GarmentPlan plan_;
  std::vector<glm::vec4> next_, forces_;
  std::vector<glm::vec4> ways_;  ///< displacements in the frame of pins that follow a skin
};
