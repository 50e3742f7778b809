#include "sim/contour/parameters.hpp"

#include "base/error.hpp"
#include "sim/contour/walls.hpp"
#include "sim/grid/color_map.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/ports/field_source.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::sim {

void ContourParameters::describe(scene::Fields& f) {
  f.text("field", field,
         "Name of the object whose field is cut by levels; NAME.u and the like if it has several fields. "
         "The field itself fills the picture unless its \"display\" has \"layer\": \"none\".");
  f.asset("image", image, "Picture that is cut instead, such as a heightmap: black is 0, white 1.");
  if (!image.empty() && !field.empty()) f.error("image", "a \"field\" is given already; leave out one");
  f.integer("levels", levels, {1, maxSolidLevels}, "", "Number of levels; each adds a terrace.");
  f.optionalNumber("low", low, scene::anyNumber, "", "Value of the lowest level.");
  f.leftOut("low", "a tenth of the range that the field is shown in");
  f.optionalNumber("high", high, scene::anyNumber, "", "Value of the highest level.");
  f.leftOut("high", "nine tenths of it");
  if (levels > 1 && low && high && !(static_cast<float>(*low) < static_cast<float>(*high)))
    f.error("low", fmt::format("\"low\" ({}) must be less than \"high\" ({})", *low, *high));
  f.vector("position", position, scene::anyNumber, "m", "Middle of the lowest face.");
  f.number("width", width, scene::positive, "m", "Width of the field.");
  f.number("height", height, scene::notNegative, "m",
           "Height of the highest terrace over the lowest face.");
  f.number("base", base, scene::positive, "m", "Material below the lowest face.");
  const std::vector<std::string>& names = colorMapNames();
  std::vector<const char*> maps;
  maps.reserve(names.size());
  for (const std::string& name : names) maps.push_back(name.c_str());
  int index = static_cast<int>(std::find(names.begin(), names.end(), map) - names.begin());
  f.oneOf("map", index, maps, "Colour map of the terraces.");
  map = names.at(static_cast<std::size_t>(index));
  f.number("grip", grip, {0, 1e6}, "1/s",
           "Rate at which sliding cloth and particles with \"walls\" lose speed.");
  f.boolean("visible", visible, "Draws it.");
  f.idleUnless(visible, "visible", {"map"}, "a contour that is \"visible\"");
  f.idleUnless(levels > 1, "levels", {"high"}, "two \"levels\" or more");
}

std::optional<scene::Box> ContourParameters::framed() const {
  if (!visible) return std::nullopt;
  float highest = 0;
  for (const auto& key : height.keys()) highest = std::max(highest, key.value);
  const float half = 0.5F * width;
  const float deep = half * aspect();
  return scene::Box{position + glm::vec3(-half, -base, -deep), position + glm::vec3(half, highest, deep)};
}

float ContourParameters::aspect() const {
  if (image.empty()) return 1;
  try {
    const glm::dvec2 size(loadPicture(image, "image", maxSolidImageSide).size);
    return static_cast<float>(std::min((size.y + 1) / (size.x + 1), 1e3));
  } catch (const UserError&) {
    return 1;  // The check of the object reports the error.
  }
}

std::vector<float> ContourParameters::heightsAt(double time) const {
  const float top = height.at(time);
  std::vector<float> heights;
  for (int k = 0; k <= levels; ++k)
    heights.push_back(top * static_cast<float>(k) / static_cast<float>(levels));
  return heights;
}

SolidShape ContourParameters::shape(const Field& source, double time) const {
  const glm::dvec2 range(source.range);
  const double first = low.value_or(range.x + 0.1 * (range.y - range.x));
  const double last = high.value_or(range.x + 0.9 * (range.y - range.x));
  if (levels > 1 && !(static_cast<float>(first) < static_cast<float>(last)))
    fail(ExitCode::usage,
         "the lowest level of the contour is {:g}, and the highest {:g}, by the values {:g} to {:g} that "
         "its field is shown with; give it \"low\" and \"high\"",
         first, last, range.x, range.y);
  SolidShape shape;
  shape.size = source.size;
  shape.levels.clear();
  for (int k = 0; k < levels; ++k)
    shape.levels.push_back(
        static_cast<float>(levels == 1 ? first : first + (last - first) * k / (levels - 1)));
  shape.heights = heightsAt(time);
  shape.spacing = width / static_cast<float>(source.size.x + 1);
  shape.base = base;
  return shape;
}

glm::vec2 ContourParameters::colorRange(const Field& source) const {
  const std::vector<float> all = shape(source, 0).levels;
  const float half = all.size() > 1 ? 0.5F * (all.back() - all.front()) / static_cast<float>(all.size() - 1)
                                    : 0.5F * (source.range.y - source.range.x);
  return {all.front() - half, all.back() + half};
}

std::vector<glm::vec3> ContourParameters::colors() const {
  const std::vector<glm::vec3> stops = colorMapStops(map);
  std::vector<glm::vec3> colors;
  for (int k = 0; k <= levels; ++k) {
    const float place =
        static_cast<float>(k) / static_cast<float>(levels) * static_cast<float>(stops.size() - 1);
    const auto left = std::min(static_cast<std::size_t>(place), stops.size() - 1);
    const auto right = std::min(left + 1, stops.size() - 1);
    colors.push_back(glm::mix(stops[left], stops[right], place - static_cast<float>(left)));
  }
  return colors;
}

void ContourParameters::ports(Ports& ports) const {
  if (image.empty()) ports.requireFrom<FieldSource>(field, {"field"});
  ports.provide<ColorScale>(visible, " that is not \"visible\"");
  ports.provide<Walls>();
}

}  // namespace simreel::sim
