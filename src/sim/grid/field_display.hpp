#pragma once
#include "scene/covering.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/auto_range.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Settings for drawing a field over the picture, used by all simulations that publish a field: the scene's
/// group "display".
struct FieldDisplay {
  /// over: drawn on the finished picture, with unmodified colours. behind: drawn behind all objects,
  /// subject to the scene's lighting and tone mapping. none: not drawn, although surfaces may use the field
  /// as a texture.
  enum class Layer { over, behind, none };
  enum class Fit { contain, cover, stretch };
  Layer layer = Layer::over;
  Fit fit = Fit::cover;
  glm::vec3 corner{0, 0, 0};  ///< Top left corner, as fractions of the picture.
  glm::vec3 extent{1, 1, 0};  ///< Width and height, as fractions of the picture.
  /// Strips at the right and at the bottom of the field's part of the picture, as fractions of the picture.
  /// A field whose fit is `contain` does not reach them.
  glm::vec2 room{0};
  scene::Animated<glm::vec3> center =
      glm::vec3(0.5F);  ///< Point of the field at the centre of the panel, as fractions of the field.
  scene::Animated<float> zoom = 1.0F;
  scene::Animated<float> opacity = 1.0F;
  bool smooth = true;  ///< True to interpolate linearly between cells, false to draw each cell as a square.
  bool tiled = false;  ///< True to repeat the field beyond its border, false to show the colour `border`
                       ///< there.
  bool sized = false;  ///< true if the scene gives the size of the grid
  glm::vec3 border{0.01F};  ///< Colour outside the field, linear RGB.
  float relief = 0.0F;      ///< Strength of the relief shading: a field value of 1 counts as a height of 7
                            ///< cells times `relief`. 0 disables the shading.
  std::string map = "viridis";   ///< Name of a colour map.
  std::vector<glm::vec3> stops;  ///< Linear RGB stops that replace the colour map.
  double low = 0, high = 1;      ///< Values of the first and the last colour.
  AutoEnds autoEnds;             ///< States which ends a first run measures. Until then, these ends have
                                 ///< their defaults.
  /// Quantity that changes linearly over the field, from its first to its last cell. It is drawn as a scale
  /// at the field's edge.
  struct Axis {
    std::string name;  ///< Symbol of the quantity, and after a comma its meaning: "F, feed rate".
    scene::Animated<float> first = 0.0F, last = 1.0F;
  };
  std::optional<Axis> across, down;  ///< Axes of a parameter map; set by simulations, not by scenes.

  /// Returns `standard`, the default size of a grid in cells, with the aspect ratio of the part of a
  /// picture (pixels) that the field fills, and about as many cells. Returns `standard` if the scene gives
  /// a size, or if the field does not have to fit its part of the picture.
  [[nodiscard]] glm::ivec2 fittedGrid(glm::ivec2 standard, glm::ivec2 picture) const;
  /// Declares the members of "display". Simulations set their own defaults first.
  void describe(scene::Fields& fields);
  /// Returns `stops`, or if they are empty the stops of the colour map.
  [[nodiscard]] std::vector<glm::vec3> colors() const;
  /// Returns the part of the picture that the display covers at time 0.
  [[nodiscard]] scene::Covering::Extent covering() const;
  /// Returns the colour range if at least one end must be measured. `path` is the path of the display's
  /// group.
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges(const char* path = "display") {
    return measuredRange(path, "low", "high", autoEnds, low, high);
  }
};

}  // namespace simreel::sim
