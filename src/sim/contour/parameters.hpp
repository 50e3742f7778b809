#pragma once
#include "scene/own_colors.hpp"
#include "sim/contour/solid.hpp"
#include "sim/core/kind.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Scene parameters of a contour: a field shown as a terraced solid.
struct ContourParameters final : ObjectParameters, scene::HasOwnColors {
  std::string field;            ///< Name of the object whose field is shown.
  std::filesystem::path image;  ///< Image used instead of a field; its levels 0 to 255 become values 0 to
                                ///< 1.
  int levels = 8;
  std::optional<double> low, high;       ///< Field values of the first and the last contour level.
  glm::vec3 position{0, -1.3F, 0};       ///< Centre of the lowest face in metres.
  float width = 4.8F;                    ///< Width of the field in metres.
  scene::Animated<float> height = 0.6F;  ///< Height of the highest face in metres.
  float base = 0.12F;                    ///< Thickness in metres of the material below the lowest face.
  std::string map = "viridis";
  float grip = 25.3F;  ///< Decay rate (1/s) of the tangential velocity of touching objects.
  bool visible = true;

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] const char* coloredBy() const override { return "its \"map\""; }
  /// Returns the bounding box for the default camera. The depth of a field is assumed to equal the width.
  [[nodiscard]] std::optional<scene::Box> framed() const override;

  /// Returns the solid's shape for a field, with the heights at `time` (seconds). Levels that are not given
  /// are derived from the range of the field's values. Throws UserError(usage) if the resulting levels are
  /// not ascending.
  [[nodiscard]] SolidShape shape(const Field& field, double time) const;
  [[nodiscard]] std::vector<float> heightsAt(double time) const;
  /// Returns the values in the middle of the first and the last class, if classes beyond the first and the
  /// last level were as wide as the others.
  [[nodiscard]] glm::vec2 colorRange(const Field& field) const;
  /// Returns the linear RGB colour of each class, starting with the lowest class.
  [[nodiscard]] std::vector<glm::vec3> colors() const;

 private:
  /// Returns the depth divided by the width of the image; 1 for a field.
  [[nodiscard]] float aspect() const;
};

/// Maximum side in pixels of an image.
inline constexpr int maxSolidImageSide = 16384;

}  // namespace simreel::sim
