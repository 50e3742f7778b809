#pragma once
#include "sim/contour/solid.hpp"
#include "sim/core/kind.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Contours of a field as a solid with terraces, as a scene says it.
struct ContourParameters final : ObjectParameters {
  std::string field;            ///< name of the object it is made of
  std::filesystem::path image;  ///< instead: levels 0 to 255 count as 0 to 1
  int levels = 8;
  std::optional<double> low, high;       ///< the first and the last level
  glm::vec3 position{0, -1.3F, 0};       ///< m: middle of the lowest face
  float width = 4.8F;                    ///< m: of the field
  scene::Animated<float> height = 0.6F;  ///< m: of the highest face
  float base = 0.12F;                    ///< m of material below the lowest
  std::string map = "viridis";
  float grip = 25.3F;  ///< 1/s at which what touches it loses tangential velocity
  bool visible = true;

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  /// How deep it is follows from its field: as if that were as deep as wide.
  [[nodiscard]] std::optional<scene::Box> framed() const override;

  /// Of that field, with the heights of `time` (s). Throws UserError(usage) where the range of its values,
  /// which stands for a level that is left out, makes levels that do not ascend.
  [[nodiscard]] SolidShape shape(const Field& field, double time) const;
  [[nodiscard]] std::vector<float> heightsAt(double time) const;
  /// Linear RGB of each class, lowest first.
  [[nodiscard]] std::vector<glm::vec3> colors() const;
};

}  // namespace simreel::sim
