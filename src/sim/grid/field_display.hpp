#pragma once
#include "scene/value/fields.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// How a field is laid over the picture, for every simulation that is a field: the group "display".
struct FieldDisplay {
  /// over: on the finished picture, colours as they are given. behind: behind everything drawn, in the
  /// scene's light and tone map. none: not shown (skins may still use it).
  enum class Layer { over, behind, none };
  enum class Fit { contain, cover, stretch };
  Layer layer = Layer::over;
  Fit fit = Fit::cover;
  glm::vec3 corner{0, 0, 0};  ///< top left, as fractions of the picture
  glm::vec3 extent{1, 1, 0};  ///< width and height, as fractions of the picture
  scene::Animated<glm::vec3> center =
      glm::vec3(0.5F);  ///< point of the field in the middle, as fractions of it
  scene::Animated<float> zoom = 1.0F;
  scene::Animated<float> opacity = 1.0F;
  bool smooth = true;            ///< linear between cells; else each cell is a square
  bool tiled = false;            ///< repeated beyond its border; else `border` is shown there
  glm::vec3 border{0.01F};       ///< linear RGB
  float relief = 0.0F;           ///< shaded as a height of 7 cells times this; 0: not
  std::string map = "viridis";   ///< name of a colour map
  std::vector<glm::vec3> stops;  ///< linear RGB, given instead of a map
  double low = 0, high = 1;      ///< values of the first and the last colour
  /// What changes evenly over the field, from its first cell to its last: drawn as a scale at its edge.
  struct Axis {
    std::string name;  ///< the symbol, and after a comma its meaning: "F, feed rate"
    scene::Animated<float> first = 0.0F, last = 1.0F;
  };
  std::optional<Axis> across, down;  ///< set by simulations, not by scenes

  /// The members of "display". Simulations set their own defaults first.
  void describe(scene::Fields& fields);
  /// The stops, or those of the map.
  [[nodiscard]] std::vector<glm::vec3> colors() const;
};

}  // namespace simreel::sim
