#include "sim/isolines/isolines.hpp"

#include "base/error.hpp"
#include "sim/grid/field_values.hpp"
#include "sim/grid/field_view.hpp"
#include "sim/isolines/labels.hpp"
#include "sim/isolines/lines.hpp"
#include "sim/isolines/parameters.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/ports/shown_picture.hpp"
#include "sim/text/letters/layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace simreel::sim {

namespace {

/// Throws UserError(usage) for characters that the font does not have.
void checkIsolines(const scene::Object& object, const Setting& /*setting*/) {
  const auto& parameters = parametersOf<IsolineParameters>(object);
  if (!parameters.labels) return;
  const Font font(parameters.fontFile());
  try {
    checkWritable(font, parameters.unit);
  } catch (const UserError& error) {
    fail(error.code(), "isolines \"{}\": {}", object.name, error.what());
  }
}

using Outlines = std::vector<std::vector<glm::vec2>>;

/// Lines of equal field values, drawn over the picture. This object has no state.
class Isolines : public Simulation {
 public:
  Isolines(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<IsolineParameters>(object)),
        links_(setting.links),
        font_(parameters_.fontFile()) {
    checkIsolines(object, setting);
  }

  void step(double /*time*/, const StepWatch& /*watch*/) override {}

  void publish(double time, Drawables& drawables) const override {
    make(time);
    for (const Outlines* outlines : {&lines_, &numbers_}) {
      if (outlines->empty()) continue;
      Writing writing;
      writing.outlines = outlines;
      writing.height = parameters_.height;
      writing.color = parameters_.color;
      writing.opacity = parameters_.opacity;
      drawables.writings.push_back(writing);
    }
  }

 private:
  /// Returns the field. If it has no display, it gets the display of its object.
  [[nodiscard]] Field field() const {
    Field found = fieldNamed(*links_, parameters_.of);
    Drawables drawables;
    links_->simulation(PartName(parameters_.of).object)->publish(links_->now(), drawables);
    for (const Field& other : drawables.fields)
      if (found.display == nullptr && other.display != nullptr && other.size == found.size)
        found.display = other.display;
    if (found.display == nullptr || found.display->layer == FieldDisplay::Layer::none)
      fail(ExitCode::usage,
           "isolines \"{}\": \"{}\" is not displayed over the picture, so it has no place for lines; give "
           "its object \"display\": {{\"layer\": \"over\"}}",
           name_, parameters_.of);
    return found;
  }

  /// Creates the outlines of lines and numbers, unless the field and its view are unchanged.
  void make(double time) const {
    const Field shown = field();
    const glm::ivec2 picture = shownPicture(links_).size;
    const FieldView view = fieldView(*shown.display, shown.size, picture, time);
    std::vector<float> values = fieldValues(shown);
    if (values == values_ && view.origin == view_.origin && view.perPixel == view_.perPixel) return;
    values_ = std::move(values);
    view_ = view;
    glm::dvec2 extremes(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
    for (const float value : values_)
      if (std::isfinite(value))
        extremes = {std::min(extremes.x, static_cast<double>(value)),
                    std::max(extremes.y, static_cast<double>(value))};
    write(parameters_.levels(glm::dvec2(shown.range), extremes), isoGrid(values_, shown.size, view),
          picture);
  }

  void write(const std::vector<IsoLevel>& levels, const IsoGrid& grid, glm::ivec2 picture) const {
    const double unit = static_cast<double>(parameters_.height) * picture.y;
    const bool some =
        std::any_of(levels.begin(), levels.end(), [](const IsoLevel& one) { return one.bold; });
    std::vector<double> at;
    std::vector<TextOutlines> texts;
    IsoLabelSizes sizes;
    sizes.capital = unit;
    for (const IsoLevel& level : levels) {
      at.push_back(level.value);
      texts.push_back(
          written(font_, level.text, {TextAnchor::Across::center, TextAnchor::Down::middle}, 1));
      const bool numbered = parameters_.labels && (level.bold || !some);
      sizes.widths.push_back(numbered ? unit * widthOf(texts.back()) : 0);
    }
    const glm::dvec4 part =
        glm::clamp(view_.part, glm::dvec4(0), glm::dvec4(picture.x, picture.y, picture.x, picture.y));
    const std::vector<IsoLine> lines = isoLines(grid, at, part);
    const std::vector<IsoLabel> labels = placeLabels(lines, sizes, part);
    lines_.clear();
    numbers_.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool bold = levels[static_cast<std::size_t>(lines[i].level)].bold;
      const double width = static_cast<double>(parameters_.width) * picture.y * (bold ? 2 : 1);
      for (const IsoLine& line : withoutLabels(lines[i], labels, unit))
        for (const auto& outline : isoStroke(line, width)) add(lines_, outline, unit);
    }
    for (const IsoLabel& label : labels) {
      const glm::dvec2 up(label.along.y, -label.along.x);
      for (const auto& outline : texts[static_cast<std::size_t>(lines[label.line].level)]) {
        std::vector<glm::dvec2> turned;
        turned.reserve(outline.size());
        for (const glm::dvec2& point : outline)
          turned.push_back(label.middle + unit * (point.x * label.along + point.y * up));
        add(numbers_, turned, unit);
      }
    }
  }

  static double widthOf(const TextOutlines& text) {
    double width = 0;
    for (const auto& outline : text)
      for (const glm::dvec2& point : outline) width = std::max(width, 2 * std::abs(point.x));
    return width;
  }

  /// Adds a polygon given in pixels, converted to the units of a Writing: the cap height, with y up.
  static void add(Outlines& outlines, const std::vector<glm::dvec2>& pixels, double unit) {
    auto& polygon = outlines.emplace_back();
    for (const glm::dvec2& point : pixels) polygon.emplace_back(point.x / unit, -point.y / unit);
  }

  std::string name_;
  IsolineParameters parameters_;
  const Links* links_;
  mutable Font font_;
  mutable std::vector<float> values_;
  mutable FieldView view_;
  mutable Outlines lines_, numbers_;
};

}  // namespace

SimulationKind isolinesKind() {
  return kindOf<IsolineParameters>("isolines", "Lines of equal values over a field, with numbers.",
                                   checkIsolines, makeSimulation<Isolines>);
}

}  // namespace simreel::sim
