#pragma once
#include "scene/beside.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Tick of a colour bar.
struct BarTick {
  double at;         ///< position along the bar, 0 to 1
  std::string text;  ///< label
};

/// Word that labels a category.
struct BarLabel {
  std::string text;
  double value = 0;     ///< value, or index of the category
  bool valued = false;  ///< true if the scene gives the value
};

/// Parameters of the object kind "colorBar".
struct ColorBarParameters : ObjectParameters, scene::TakesRoom {
  std::string of;                ///< name of a field or of particles, OBJECT or OBJECT.PART
  std::string title;             ///< text above the bar; if empty, the quantity that the colours show
  std::string unit;              ///< appended to the title in parentheses
  std::vector<BarLabel> labels;  ///< words shown in place of numbers; if empty, numbers or all categories
                                 ///< are shown
  int ticks = 5;                 ///< approximate number of ticks to draw
  bool horizontal = false;
  bool placed = false;  ///< true if the scene gives the corner; otherwise the bar is moved so that it stays
                        ///< in the picture
  bool keepsRoom = false;  ///< true since version 2: nothing else is drawn behind a bar without a corner
  glm::vec3 corner{0.88F, 0.22F, 0};  ///< top left corner of the bar, as fractions of the picture
  glm::vec3 extent{0.02F, 0.56F, 0};  ///< width and height of the bar, as fractions of the picture
  float height = 0.02F;               ///< height of capitals, as a fraction of the picture's height
  glm::vec3 color{1};                 ///< colour of text and ticks, linear RGB
  std::filesystem::path font;         ///< font file; if empty, the bundled font
  float backdrop = 0.45F;             ///< opacity of the dark panel behind the bar

  void describe(scene::Fields& fields) override;
  void ports(Ports& ports) const override;
  [[nodiscard]] std::filesystem::path fontFile() const;
  [[nodiscard]] glm::vec2 room() const override;
  [[nodiscard]] const char* drawnWith() const override { return "its \"color\""; }
};

/// Returns about `count` ticks at round numbers within a range. Their distance is 1, 2 or 5 times a power
/// of ten. The ends of the range may be in any order.
[[nodiscard]] std::vector<BarTick> barTicks(double first, double last, int count);

}  // namespace simreel::sim
