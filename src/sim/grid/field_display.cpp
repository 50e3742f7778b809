#include "sim/grid/field_display.hpp"

#include "sim/grid/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace simreel::sim {

void FieldDisplay::describe(scene::Fields& fields) {
  fields.choice("layer", layer, {"over", "behind", "none"},
                "over: on the finished picture; behind: behind all objects; none: not shown.");
  if (fields.version() > 1 && !fields.given("fit")) fit = Fit::contain;
  fields.choice("fit", fit, {"contain", "cover", "stretch"},
                "Fit of the field into its part of the picture: all of it, or as much as fills the part.");
  fields.leftOut("fit", "cover; in version 2 contain");
  fields.vector(
      "corner", corner, {-10, 10}, "",
      "Top left of its part, as fractions of the picture's width and height; the third is unused.");
  fields.vector("extent", extent, {0, 10}, "",
                "Width and height of its part, as fractions of the picture.");
  fields.vector("center", center, {-1e6, 1e6}, "", "Point of the field in the middle, as fractions of it.");
  fields.number("zoom", zoom, {1e-3, 1e6}, "", "Magnification.");
  fields.number("opacity", opacity, {0, 1}, "", "Opacity; 0 hides it.");
  fields.boolean("smooth", smooth, "Smooth between cells; else each cell is a square.");
  fields.boolean("tiled", tiled, "Repeated beyond its border.");
  fields.color("border", border, scene::notNegative, "Colour beyond its border, linear RGB.");
  fields.number("relief", relief, {-100, 100}, "",
                "Shaded as if lit from the top left: height of the whole range, 1 being 7 cells.");
  const std::vector<std::string>& names = colorMapNames();
  std::vector<const char*> maps;
  maps.reserve(names.size());
  for (const std::string& name : names) maps.push_back(name.c_str());
  // The default colours of a simulation take precedence over the default map, unless the scene names a map.
  int index =
      stops.empty() ? static_cast<int>(std::find(names.begin(), names.end(), map) - names.begin()) : -1;
  fields.oneOf("map", index, maps, "Colour map.");
  if (index >= 0) map = names.at(static_cast<std::size_t>(index));
  struct Stop {
    glm::vec3 color{1};
  };
  std::vector<Stop> given;
  for (const glm::vec3& color : stops) given.push_back({color});
  fields.list("stops", given, "Evenly spaced colours instead of a map.", [](scene::Fields& f, Stop& stop) {
    f.color("color", stop.color, scene::notNegative, "Linear RGB.");
  });
  if (fields.given("stops")) {
    stops.clear();
    for (const Stop& stop : given) stops.push_back(stop.color);
  } else if (fields.given("map")) {
    stops.clear();  // A map in the scene replaces the simulation's default colours.
  }
  fields.idleUnless(layer != Layer::none, "layer",
                    {"fit", "corner", "extent", "center", "zoom", "opacity", "tiled", "border", "relief"},
                    "a field that is laid over the picture, with \"layer\": \"over\" or \"behind\"");
  if (layer != Layer::none) fields.idleUnless(!tiled, "tiled", {"border"}, "a field that is not \"tiled\"");
  fields.idleUnless(!fields.given("stops"), "stops", {"map"}, "a display without \"stops\"");
  describeEnd(fields, "low", low, autoEnds.low, "",
              "Value of the first colour; \"auto\": the lowest of the whole run.");
  describeEnd(fields, "high", high, autoEnds.high, "",
              "Value of the last colour; \"auto\": the highest of the whole run.");
  if (!(low < high) && autoEnds.low) low = high - 1;
  if (!(low < high) && autoEnds.high) high = low + 1;
  if (!(low < high))
    fields.error(fields.given("low") ? "low" : "high",
                 fmt::format("\"low\" ({}) must be less than \"high\" ({})", low, high));
}

glm::ivec2 FieldDisplay::fittedGrid(glm::ivec2 standard, glm::ivec2 picture) const {
  const glm::dvec2 part = glm::dvec2(picture) * glm::dvec2(extent.x, extent.y);
  if (sized || layer == Layer::none || fit != Fit::contain || !(part.x > 0) || !(part.y > 0))
    return standard;
  // Integer sides with exactly the picture's ratio, such as 16k x 9k, leave no border.
  const glm::ivec2 whole(std::lround(part.x), std::lround(part.y));
  const int divisor = std::max(std::gcd(whole.x, whole.y), 1);
  const glm::dvec2 ratio = glm::dvec2(whole) / static_cast<double>(divisor);
  const double scale = std::sqrt(static_cast<double>(standard.x) * standard.y / (ratio.x * ratio.y));
  const double times = scale >= 8 ? std::round(scale) : scale;
  return glm::max(glm::ivec2(std::lround(times * ratio.x), std::lround(times * ratio.y)), glm::ivec2(8));
}

scene::Covering::Extent FieldDisplay::covering() const {
  using Extent = scene::Covering::Extent;
  if (layer == Layer::none) return Extent::none;
  if (layer == Layer::behind) return Extent::behind;
  const bool whole = corner.x <= 0 && corner.y <= 0 && corner.x + extent.x >= 1 && corner.y + extent.y >= 1;
  return whole && opacity.at(0) >= 1 ? Extent::whole : Extent::part;
}

std::vector<glm::vec3> FieldDisplay::colors() const {
  return stops.empty() ? colorMapStops(map) : stops;
}

}  // namespace simreel::sim
