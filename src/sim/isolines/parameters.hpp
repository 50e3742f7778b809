#pragma once
#include "sim/core/kind.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Value at which a line is drawn.
struct IsoLevel {
  double value = 0;
  std::string text;   ///< text shown on the line
  bool bold = false;  ///< true if the line is thick
};

/// Parameters of the object kind "isolines".
struct IsolineParameters : ObjectParameters {
  std::string of;               ///< name of a field, OBJECT or OBJECT.PART; empty if `terrain` is given
  std::string terrain;          ///< name of an object with a surface (Landform); empty if `of` is given
  double scale = 1;             ///< factor from heights of the surface in metres to values
  double zero = 0;              ///< value at the height 0
  std::optional<double> every;  ///< distance between two levels
  scene::Formula at;            ///< levels; if empty, multiples of `every`
  int bold = 0;                 ///< every `bold`-th level has a thick line; 0 for none
  bool labels = true;
  std::string unit;        ///< unit appended to the numbers
  glm::vec3 color{0.01F};  ///< line colour, linear RGB
  bool contrasts = false;  ///< true since version 2 if the scene gives no colour: lines over dark colours
                           ///< of the field are light
  float opacity = 0.85F;
  /// Width of a line and height of capitals as fractions of the picture's height, or on a surface of its
  /// longer side.
  float width = 0.0022F, height = 0.018F;
  std::filesystem::path font;  ///< font file; if empty, the bundled font

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::filesystem::path fontFile() const;
  [[nodiscard]] const char* drawnWith() const override { return "its \"color\""; }
  /// Returns the levels of the lines over a field in ascending order. `colors` is the colour range; without
  /// "every", the distance between levels is a tenth of it, rounded. `values` are the minimum and maximum
  /// of the field, between which the multiples are. Throws UserError(usage) for more than maxIsoLevels
  /// levels.
  [[nodiscard]] std::vector<IsoLevel> levels(glm::dvec2 colors, glm::dvec2 values) const;
};

constexpr int maxIsoLevels = 200;

}  // namespace simreel::sim
