#include "sim/flow/look.hpp"

#include "sim/flow/speed_range.hpp"
#include "sim/grid/color_map.hpp"

#include <algorithm>
#include <cstddef>

namespace simreel::sim {

void describeColors(scene::Fields& f, std::vector<glm::vec3>& stops) {
  static const std::vector<const char*> words = {"viridis", "magma", "inferno", "plasma",
                                                 "turbo",   "grey",  "material"};
  int map = 0;
  f.oneOf("colors", map, words, "Colour map of the speed; material: the colour of the object's material.");
  stops = colorMapStops(words[static_cast<std::size_t>(map)]);
}

void SpeedRange::describe(scene::Fields& f, const char* highDoc, const char* leftOut) {
  f.number("low", low, scene::notNegative, "m/s", "Speed of the first colour.");
  double end = low + 1;
  ends.high = f.version() > 1 && !f.given("high");
  describeEnd(f, "high", end, ends.high, "m/s", highDoc);
  f.leftOut("high", leftOut);
  if (!f.given("high") || ends.high) return;
  high = end;
  if (end <= low) f.error("high", "\"high\" must be above \"low\"");
}

std::vector<MeasuredRange> SpeedRange::measured() {
  if (!ends.any()) return {};
  return {{"", "low", "high", ends, low, last(0), [this](double /*low*/, double measured) {
             high = measured;
             ends = {};
           }}};
}

double SpeedRange::last(double fastest) const {
  return high.value_or(std::max(fastest, low + 1e-3 * std::max(1.0, low)));
}

}  // namespace simreel::sim
