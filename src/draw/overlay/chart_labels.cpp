#include "draw/overlay/chart_labels.hpp"

#include "base/file.hpp"
#include "draw/overlay/chart_pass.hpp"
#include "sim/text/letters/layout.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::draw {

namespace {

constexpr float capital = 7.5F;                   // height of capitals, in units of the chart layout
constexpr float smallest = 0.5F;                  // smallest factor on the height of names that do not fit
constexpr glm::vec3 dim(0.342F, 0.380F, 0.448F);  // linear RGB colour of the numbers on the axes

/// Returns the number with spaces between thousands, for example 65 536.
std::string groupedDigits(unsigned number) {
  std::string digits = fmt::format("{}", number);
  for (auto at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), " ");
  return digits;
}

}  // namespace

sim::Font& LabelWords::font() {
  if (!font_) font_ = std::make_unique<sim::Font>(assetFolder() / "fonts/OpenSans-Regular.ttf");
  return *font_;
}

void LabelWords::require(const std::string& text) {
  sim::checkWritable(font(), text);
}

const LabelWord& LabelWords::of(const std::string& text) {
  const auto found = words_.find(text);
  if (found != words_.end()) return found->second;
  constexpr std::size_t maximum = 64;  // max number of characters of a label
  constexpr sim::TextAnchor anchor{sim::TextAnchor::Across::left, sim::TextAnchor::Down::baseline};
  LabelWord made;
  for (const auto& polygon : sim::written(font(), text.substr(0, maximum), anchor, 1)) {
    auto& cached = made.outlines.emplace_back();
    for (const glm::dvec2& point : polygon) {
      cached.emplace_back(point);
      made.width = std::max(made.width, cached.back().x);
    }
  }
  return words_.emplace(text, std::move(made)).first->second;
}

void LabelWords::forget() {
  constexpr std::size_t enough = 500;
  if (words_.size() > enough) words_.clear();
}

std::vector<sim::Writing> ChartLabels::of(const sim::Drawables& drawables) {
  words_.forget();
  std::vector<sim::Writing> all;
  for (const sim::Chart& chart : drawables.charts) {
    const ChartLayout layout = chartLayout(chart, picture_);
    if (!layout.hasLetters) continue;
    const auto u = static_cast<float>(layout.unit);
    const auto left = static_cast<float>(layout.plot.x), right = static_cast<float>(layout.plot.z);
    const auto add = [&](const LabelWord& word, glm::vec2 at, glm::vec3 color, float scale = 1) {
      sim::Writing writing;
      writing.outlines = &word.outlines;
      writing.place = at / glm::vec2(picture_);
      writing.height = scale * capital * u / static_cast<float>(picture_.y);
      writing.color = color;
      all.push_back(writing);
    };
    const float above = static_cast<float>(layout.panel.y) + 15 * u;
    const float below = static_cast<float>(layout.plot.w) + 13 * u;
    const std::size_t names = std::min<std::size_t>({chart.names.size(), chart.colors.size(), 4});
    float whole = 0;
    for (std::size_t i = 0; i < names; ++i)
      whole += capital * u * words_.of(chart.names[i]).width + (i > 0 ? 8 * u : 0);
    const float scale = std::clamp((right - left) / std::max(whole, 1.0F), smallest, 1.0F);
    float at = left;
    for (std::size_t i = 0; i < names; ++i) {
      const LabelWord& name = words_.of(chart.names[i]);
      const float width = scale * capital * u * name.width;
      if (at + width > right + 0.5F) break;
      add(name, {at, above}, chart.colors[i], scale);
      at += width + scale * 8 * u;
    }
    const LabelWord& top = words_.of(chart.range.empty() ? "max " + groupedDigits(chart.max) : chart.range);
    const LabelWord& end =
        words_.of(!chart.length.empty()
                      ? chart.length
                      : groupedDigits(static_cast<unsigned>(std::max(chart.width - 1, 0))) + " steps");
    const float wide = capital * u * end.width;
    if (left + capital * u * top.width + wide + 6 * u <= right) add(top, {left, below}, dim);
    if (left + wide <= right) add(end, {right - wide, below}, dim);
  }
  return all;
}

}  // namespace simreel::draw
