#pragma once
#include "scene/picture_area.hpp"
#include "sim/core/kind.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Length of a scale bar, and its text.
struct ScaleLength {
  double length = 0;  ///< length in the unit of the bar
  std::string text;   ///< text such as "200 m"
};

/// Returns the maximum length that is 1, 2 or 5 times a power of ten and at most `most` (above 0). Metres
/// are written as km, m, cm, mm, um or nm.
[[nodiscard]] ScaleLength roundLength(double most, const std::string& unit);
/// Returns a length with its text.
[[nodiscard]] ScaleLength givenLength(double length, const std::string& unit);

/// Parameters of the object kind "scaleBar".
struct ScaleBarParameters : ObjectParameters, scene::MovesAside {
  std::string of;                     ///< name of a field; if empty, the bar shows the scale of the
                                      ///< camera's picture
  double cell = 1;                    ///< width of a cell of the field, in `unit`
  std::string unit;                   ///< unit of lengths
  std::optional<double> length;       ///< length of the bar; if empty, a round length
  float most = 0.25F;                 ///< maximum length as a fraction of the picture's width
  glm::vec3 corner{0.05F, 0.93F, 0};  ///< position of the bar's left end, as fractions of the picture
  bool moves = false;                 ///< true since version 2 if the scene gives no corner
  float height = 0.025F;              ///< height of capitals as a fraction of the picture's height
  std::filesystem::path font;         ///< font file; if empty, the bundled font
  glm::vec3 color{1};                 ///< colour, linear RGB
  float backdrop = 0.45F;             ///< opacity of the dark panel behind the bar

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  void moveAside(const std::vector<scene::PictureArea>& taken) override;
  [[nodiscard]] std::filesystem::path fontFile() const;
  [[nodiscard]] const char* drawnWith() const override { return "its \"color\""; }
};

}  // namespace simreel::sim
