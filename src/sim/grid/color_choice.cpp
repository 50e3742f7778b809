#include "sim/grid/color_choice.hpp"

#include "sim/grid/color_map.hpp"

#include <iterator>

namespace simreel::sim {

namespace {

struct ColorStop {
  glm::vec3 color{1, 1, 1};
};

constexpr const char* colorMaps[] = {"viridis", "magma", "inferno", "plasma", "turbo", "grey"};

}  // namespace

std::vector<glm::vec3> describeColors(scene::Fields& fields, const std::string& what) {
  int map = 0;
  fields.oneOf("colors", map, {std::begin(colorMaps), std::end(colorMaps)}, "Colour map.");
  std::vector<ColorStop> stops;
  fields.list(
      "colorStops", stops, "A colour map of one's own instead: colours at even distances.",
      [](scene::Fields& s, ColorStop& stop) {
        s.color("color", stop.color, {0, 1e3}, "Linear red, green, blue.");
      },
      64);
  if (stops.size() == 1) fields.error("colorStops", "a colour map needs at least two stops");
  fields.idleUnless(stops.empty(), "colorStops", {"colors"}, what + " without \"colorStops\"");
  if (stops.empty()) return colorMapStops(colorMaps[map]);
  std::vector<glm::vec3> colors;
  colors.reserve(stops.size());
  for (const ColorStop& stop : stops) colors.push_back(stop.color);
  return colors;
}

}  // namespace simreel::sim
