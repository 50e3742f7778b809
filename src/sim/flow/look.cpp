#include "sim/flow/look.hpp"

#include "sim/grid/color_map.hpp"

#include <cstddef>

namespace simreel::sim {

void describeColors(scene::Fields& f, std::vector<glm::vec3>& stops) {
  static const std::vector<const char*> words = {"viridis", "magma", "inferno", "plasma",
                                                 "turbo",   "grey",  "material"};
  int map = 0;
  f.oneOf("colors", map, words, "Colour map of the speed; material: the colour of the object's material.");
  stops = colorMapStops(words[static_cast<std::size_t>(map)]);
}

}  // namespace simreel::sim
