#include "sim/color_bar/color_bar.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "sim/color_bar/parameters.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/text/letters/layout.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::sim {

namespace {

constexpr int rampCells = 256;
constexpr int maxUnnamed = 16;  // maximum number of categories that are shown without labels

/// Returns the title and the unit. A title that the scene leaves out is the quantity that the colours show,
/// or the name of the object.
std::string headingOf(const ColorBarParameters& parameters, const Links* links) {
  std::string title = parameters.title, unit = parameters.unit;
  if (title.empty()) {
    const ShownQuantity shown =
        links == nullptr ? ShownQuantity{""} : shownQuantityOf(*links, parameters.of);
    const bool known = shown.name[0] != '\0';
    title = known ? shown.name : parameters.of;
    if (unit.empty() && known) unit = shown.unit;
  }
  return unit.empty() ? title : fmt::format("{} ({})", title, unit);
}

/// Throws UserError(usage) for characters that the font does not have.
void checkBar(const scene::Object& object, const Setting& setting) {
  const auto& parameters = parametersOf<ColorBarParameters>(object);
  const Font font(parameters.fontFile());
  try {
    checkWritable(font, headingOf(parameters, setting.links));
    for (const BarLabel& label : parameters.labels) checkWritable(font, label.text);
  } catch (const UserError& error) {
    fail(error.code(), "colorBar \"{}\": {}", object.name, error.what());
  }
}

/// Polygons relative to the bar's top left corner, in units of the cap height; x points right and y up.
using Outlines = std::vector<std::vector<glm::vec2>>;

/// Colour bar with ticks and numbers, drawn over the picture. It has no state.
class ColorBar : public Simulation {
 public:
  ColorBar(const scene::Object& object, const Setting& setting)
      : name_(object.name),
        parameters_(parametersOf<ColorBarParameters>(object)),
        links_(setting.links),
        aspect_(setting.aspect),
        font_(parameters_.fontFile()) {
    checkBar(object, setting);
    panel_ = gl::WordsArray(name_ + " panel", 1);
    panel_.write(std::vector<glm::uvec4>(1));
    panelColors_ = {glm::vec3(0), glm::vec3(0)};
  }

  void step(double /*time*/, const StepWatch& /*watch*/) override {}

  void publish(double /*time*/, Drawables& drawables) const override {
    scale_ = colorScaleOf(*links_, parameters_.of);
    if (made_ != std::pair(scale_.range, scale_.colors.size())) make();
    drawables.fields.push_back(field(panel_, {1, 1}, panelColors_, panelDisplay_));
    Field ramp = field(ramp_, rampSize_, scale_.colors, rampDisplay_);
    ramp.categories = scale_.categories;
    drawables.fields.push_back(ramp);
    Writing writing;
    writing.outlines = &outlines_;
    writing.place = corner_;
    writing.height = parameters_.height;
    writing.color = parameters_.color;
    drawables.writings.push_back(writing);
  }

 private:
  [[nodiscard]] Field field(const gl::WordsArray& words, glm::ivec2 size,
                            const std::vector<glm::vec3>& colors, const FieldDisplay& display) const {
    Field made;
    made.name = &name_;
    made.words = &words.view();
    made.size = size;
    made.rowWords = size.x;
    made.colors = &colors;
    made.display = &display;
    made.decoration = true;
    return made;
  }

  /// Creates ramp, ticks and panel for the current scale.
  void make() const {
    made_ = {scale_.range, scale_.colors.size()};
    const std::vector<float> colors = shown();
    const int cells = static_cast<int>(colors.size());
    rampSize_ = parameters_.horizontal ? glm::ivec2(cells, 1) : glm::ivec2(1, cells);
    std::vector<float> values(static_cast<std::size_t>((cells + 3) / 4 * 4));
    for (int i = 0; i < cells; ++i)
      values[static_cast<std::size_t>(i)] =
          colors[static_cast<std::size_t>(parameters_.horizontal ? i : cells - 1 - i)];
    ramp_ = gl::WordsArray(name_ + " ramp", static_cast<int>(values.size() / 4));
    ramp_.buffer().write(0, std::as_bytes(std::span(values)));
    rampDisplay_.fit = panelDisplay_.fit = FieldDisplay::Fit::stretch;
    rampDisplay_.smooth = !scale_.categories;
    rampDisplay_.extent = parameters_.extent;
    write();
  }

  /// Returns the values that the bar shows from its low to its high end.
  [[nodiscard]] std::vector<float> shown() const {
    std::vector<float> values;
    if (!scale_.categories)
      for (int i = 0; i < rampCells; ++i) values.push_back(static_cast<float>(i) / (rampCells - 1));
    for (const BarLabel& one : categories()) values.push_back(static_cast<float>(one.value));
    return values;
  }

  /// Returns the categories to show; none for a scale of numbers.
  [[nodiscard]] std::vector<BarLabel> categories() const {
    const int count = static_cast<int>(scale_.colors.size());
    if (!scale_.categories) return {};
    std::vector<BarLabel> all = parameters_.labels;
    const auto& classes = scale_.classes;
    // Words without values name the classes of the field, if there are as many words as classes.
    if (all.empty())
      for (const auto& [value, name] : classes) all.push_back({name, static_cast<double>(value)});
    else if (all.size() == classes.size())
      for (std::size_t i = 0; i < all.size(); ++i)
        if (!all[i].valued) all[i].value = classes[i].first;
    for (const BarLabel& label : all)
      if (!(label.value >= 0 && label.value < count && label.value == std::floor(label.value)))
        fail(ExitCode::usage,
             "colorBar \"{}\": the label \"{}\" has the value {:g}, but \"{}\" has the values 0 to {}",
             name_, label.text, label.value, parameters_.of, count - 1);
    if (!all.empty()) return all;
    if (count > maxUnnamed)
      fail(ExitCode::usage,
           "colorBar \"{}\": \"{}\" has {} categories; choose with \"labels\": [{{\"value\": 1, "
           "\"text\": \"...\"}}]",
           name_, parameters_.of, count);
    all.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) all.push_back({fmt::format("{}", i), static_cast<double>(i)});
    return all;
  }

  [[nodiscard]] std::vector<BarTick> ticks() const {
    std::vector<BarTick> all;
    if (!scale_.categories && parameters_.labels.empty())
      return barTicks(scale_.range.x, scale_.range.y, parameters_.ticks);
    if (!scale_.categories) {
      for (const BarLabel& label : parameters_.labels) {
        const float at =
            (static_cast<float>(label.value) - scale_.range.x) / (scale_.range.y - scale_.range.x);
        if (!(at >= 0 && at <= 1))
          fail(ExitCode::usage,
               "colorBar \"{}\": the label \"{}\" has the value {:g}, but the colours of \"{}\" go from "
               "{:g} to {:g}",
               name_, label.text, label.value, parameters_.of, scale_.range.x, scale_.range.y);
        all.push_back({at, label.text});
      }
      return all;
    }
    const std::vector<BarLabel> labels = categories();
    for (std::size_t i = 0; i < labels.size(); ++i)
      all.push_back({(static_cast<double>(i) + 0.5) / static_cast<double>(labels.size()), labels[i].text});
    return all;
  }

  void add(const std::string& text, const TextAnchor& anchor, glm::vec2 at) const {
    for (const auto& polygon : written(font_, text, anchor, 1)) {
      auto& moved = outlines_.emplace_back();
      for (const glm::dvec2& point : polygon) moved.push_back(at + glm::vec2(point));
    }
  }

  /// Adds title, ticks and numbers, and puts the panel around them and the bar.
  void write() const {
    constexpr float tick = 0.45F, gap = 0.35F, thin = 0.06F;
    // Size of the bar in units of the cap height.
    const glm::vec2 bar(parameters_.extent.x * aspect_ / parameters_.height,
                        parameters_.extent.y / parameters_.height);
    const bool across = parameters_.horizontal;
    outlines_.clear();
    for (const BarTick& one : ticks()) {
      const auto part = static_cast<float>(one.at);
      const glm::vec2 at = across ? glm::vec2(part * bar.x, -bar.y) : glm::vec2(bar.x, (part - 1) * bar.y);
      const glm::vec2 along = across ? glm::vec2(0, -tick) : glm::vec2(tick, 0);
      const glm::vec2 side = across ? glm::vec2(thin, 0) : glm::vec2(0, thin);
      outlines_.push_back({at - side, at + along - side, at + along + side, at + side});
      const glm::vec2 label = at + along + (across ? glm::vec2(0, -gap) : glm::vec2(gap, 0));
      add(one.text,
          across ? TextAnchor{TextAnchor::Across::center, TextAnchor::Down::top}
                 : TextAnchor{TextAnchor::Across::left, TextAnchor::Down::middle},
          label);
    }
    add(headingOf(parameters_, links_), {TextAnchor::Across::left, TextAnchor::Down::baseline}, {0, 1});
    glm::vec2 low(0, -bar.y), high(bar.x, 0);
    for (const auto& polygon : outlines_)
      for (const glm::vec2& point : polygon) {
        low = glm::min(low, point);
        high = glm::max(high, point);
      }
    constexpr float margin = 1;
    const glm::vec2 unit(parameters_.height / aspect_, parameters_.height);
    low -= margin;
    high += margin;
    constexpr float border = 0.985F;  // maximum position of the panel's right and bottom ends, as a
                                      // fraction of the picture, for a bar without a given corner
    corner_ = parameters_.corner;
    if (!parameters_.placed) {
      corner_.x = std::min(corner_.x, border - high.x * unit.x);
      corner_.y = std::min(corner_.y, border + low.y * unit.y);
    }
    rampDisplay_.corner = corner_;
    panelDisplay_.corner = corner_ + glm::vec3(low.x * unit.x, -high.y * unit.y, 0);
    panelDisplay_.extent = glm::vec3((high - low) * unit, 0);
    panelDisplay_.opacity = parameters_.backdrop;
  }

  std::string name_;
  ColorBarParameters parameters_;
  const Links* links_;
  float aspect_;  ///< width of the picture divided by its height
  mutable Font font_;
  mutable gl::WordsArray panel_, ramp_;
  mutable glm::ivec2 rampSize_{1, 1};
  mutable glm::vec3 corner_{0};  ///< top left corner of the bar, as fractions of the picture
  std::vector<glm::vec3> panelColors_;
  mutable FieldDisplay panelDisplay_, rampDisplay_;
  mutable ColorScale scale_;
  mutable std::pair<glm::vec2, std::size_t> made_{glm::vec2(0), 0};
  mutable Outlines outlines_;
};

}  // namespace

SimulationKind colorBarKind() {
  return kindOf<ColorBarParameters>(
      "colorBar", "A bar that explains the colours of a field or of particles, with numbers.", checkBar,
      makeSimulation<ColorBar>);
}

}  // namespace simreel::sim
