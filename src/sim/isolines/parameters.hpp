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
  std::string text;   ///< number on the line
  bool bold = false;  ///< true for a thick line
};

/// Parameters of the object kind "isolines".
struct IsolineParameters : ObjectParameters {
  std::string of;               ///< name of a field, OBJECT or OBJECT.PART
  std::optional<double> every;  ///< distance between two levels
  scene::Formula at;            ///< levels; empty: multiples of `every`
  int bold = 0;                 ///< every so many levels one is thick; 0: none
  bool labels = true;
  std::string unit;        ///< appended to the numbers
  glm::vec3 color{0.01F};  ///< linear RGB
  float opacity = 0.85F;
  float width = 0.0022F;       ///< width of a line as a fraction of the picture's height
  float height = 0.018F;       ///< height of capitals as a fraction of the picture's height
  std::filesystem::path font;  ///< font file; empty: the bundled font

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::filesystem::path fontFile() const;
  [[nodiscard]] const char* drawnWith() const override { return "its \"color\""; }
  /// Returns the levels of lines over a field in ascending order. `colors`: range of its colours, whose
  /// tenth, rounded, is the distance of levels without "every"; `values`: its extremes, between which the
  /// multiples lie. Throws UserError(usage) for more than maxIsoLevels levels.
  [[nodiscard]] std::vector<IsoLevel> levels(glm::dvec2 colors, glm::dvec2 values) const;
};

constexpr int maxIsoLevels = 200;

}  // namespace simreel::sim
