#pragma once
#include "sim/core/kind.hpp"

#include <filesystem>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Length of a scale bar and its text.
struct ScaleLength {
  double length = 0;  ///< in units of the scene
  std::string text;   ///< "200 m"
};

/// Returns the greatest length of 1, 2 or 5 times a power of ten that is at most `most` (above 0). Metres
/// are written as km, m, cm, mm, um or nm.
[[nodiscard]] ScaleLength roundLength(double most, const std::string& unit);
/// Returns a length with its text.
[[nodiscard]] ScaleLength givenLength(double length, const std::string& unit);

/// Parameters of the object kind "scaleBar".
struct ScaleBarParameters : ObjectParameters {
  std::string of;                     ///< name of a field; empty: the scale of the camera's picture
  double cell = 1;                    ///< size of a cell of the field, in `unit`
  std::string unit;                   ///< unit of lengths
  std::optional<double> length;       ///< length of the bar; nullopt: a round one
  float most = 0.25F;                 ///< greatest length as a fraction of the picture's width
  glm::vec3 corner{0.05F, 0.93F, 0};  ///< left end of the bar, as fractions of the picture
  float height = 0.025F;              ///< height of capitals as a fraction of the picture's height
  std::filesystem::path font;         ///< font file; empty: the bundled font
  glm::vec3 color{1};                 ///< linear RGB
  float backdrop = 0.45F;             ///< opacity of the dark panel behind it

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::filesystem::path fontFile() const;
  [[nodiscard]] const char* drawnWith() const override { return "its \"color\""; }
};

}  // namespace simreel::sim
