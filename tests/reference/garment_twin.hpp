#pragma once
#include "reference/distance_twin.hpp"
#include "reference/walls_twin.hpp"
#include "reference/wind_twin.hpp"
#include "sim/garment/plan.hpp"
#include "sim/mesh/height_plan.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of mesh cloth. It runs the kernels' own model (glsl/garment compiled as C++) in plain loops.
/// Equals the GPU bit for bit in exact mode.
class GarmentTwin {
 public:
  explicit GarmentTwin(simreel::sim::GarmentPlan plan);

  /// Steps one frame that starts at `time` (seconds).
  void step(double time);
  /// Steps one substep with the given data. `index`: index of the substep in the frame.
  void substep(const simreel::shader::ClothStep& data, int index = 0);
  /// Returns the normals of the cloth's vertices.
  [[nodiscard]] std::vector<glm::vec3> normals() const;

  std::vector<glm::vec4> positions;   ///< positions (xyz, metres); w: inverse mass
  std::vector<glm::vec4> velocities;  ///< velocities (xyz, m/s); w: pin group
  std::vector<glm::vec4> trends;      ///< velocity changes, xyz in m/s; for pinned vertices the rest
                                      ///< position in metres
  /// Deformed mesh that the cloth may touch.
  std::optional<simreel::sim::HeightPlan> heightPlan;
  std::vector<glm::vec4> heights;      ///< heights of the mesh in metres: x at the frame's start, y at the
                                       ///< frame's end
  std::optional<DistanceTwin> meshes;  ///< rigid meshes that the cloth may touch
  std::optional<WallsTwin> walls;      ///< solid that the cloth may touch
  std::optional<WindTwin> wind;        ///< fluid whose wind acts on the cloth
  [[nodiscard]] simreel::sim::GarmentPlan& plan() { return plan_; }

 private:
  void resolveThin(const simreel::shader::ClothStep& data);
  simreel::sim::GarmentPlan plan_;
  std::vector<glm::vec4> next_, forces_;
  std::vector<glm::vec4>
      pinDisplacements_;  ///< displacement during the frame of each pin that follows a skin
};
