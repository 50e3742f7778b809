#include "sim/color_bar/parameters.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "sim/ports/color_scale.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::sim {

void ColorBarParameters::describe(scene::Fields& f) {
  f.text(
      "of", of,
      "Object whose colours it explains: a field, NAME or NAME.PART, or particles, a cloth or the points "
      "of kernels with \"colorBy\".");
  f.text("title", title, "Text above the bar.");
  f.leftOut("title", "the value of \"of\"; in version 2 the quantity, such as speed, where it is known");
  f.text("unit", unit, "Unit of the numbers, after the title.");
  f.leftOut("unit", "none; in version 2 without a \"title\" the quantity's");
  f.shorthand("labels", "text");
  f.list("labels", labels,
         "Words in place of numbers, each at its value; for a field of categories, the categories to show.",
         [](scene::Fields& l, BarLabel& label) {
           l.text("text", label.text, "Word beside the colour.");
           l.number("value", label.value, {-1e9, 1e9}, "", "Value that has this colour.");
           l.leftOut("value", "the label's place in the list, from 0");
           label.valued = l.given("value");
         });
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (!labels[i].valued) labels[i].value = static_cast<double>(i);
  f.integer("ticks", ticks, {2, 20}, "", "Approximate number of ticks; they stand at round numbers.");
  f.boolean("horizontal", horizontal, "Lays the bar down; its numbers are below it.");
  f.vector("corner", corner, {-10, 10}, "",
           "Top left corner of the bar as fractions of the picture, [x, y, 0].");
  f.leftOut(
      "corner",
      "[0.88, 0.22, 0], or [0.3, 0.88, 0] if horizontal, moved so that the numbers stay in the picture; in "
      "version 2 fields and the automatic camera leave room for it");
  f.vector("extent", extent, {0, 10}, "",
           "Width and height of the bar as fractions of the picture, [x, y, 0].");
  f.leftOut("extent", "[0.02, 0.56, 0], or [0.4, 0.025, 0] if horizontal");
  f.number("height", height, {0.001, 1}, "",
           "Height of capital letters, as a fraction of the picture's height.");
  f.asset("font", font, "A TrueType or OpenType file.");
  f.leftOut("font", "Open Sans, which ships with simreel");
  f.color("color", color, scene::notNegative, "Colour of text and ticks, linear RGB.");
  if (f.version() > 1 && !f.given("backdrop")) backdrop = 0.7F;
  f.number("backdrop", backdrop, scene::fraction, "", "Opacity of the dark panel behind it.");
  f.leftOut("backdrop", "0.45; in version 2 0.7");
  placed = f.given("corner");
  if (horizontal && !placed) corner = {0.3F, 0.88F, 0};
  if (!(extent.x > 0 && extent.y > 0)) f.error("extent", "\"extent\" needs a width and a height above 0");
  if (horizontal && !f.given("extent")) extent = {0.4F, 0.025F, 0};
  keepsRoom = f.version() > 1;
  if (title.empty() && !keepsRoom) title = of;
  if (of.empty()) f.error("of", "whose colours? Give \"of\", the name of a field, particles or cloth");
  for (const std::string* text : {&title, &unit})
    if (!isUtf8(*text)) f.error(text == &unit ? "unit" : "title", "the text is not UTF-8");
}

glm::vec2 ColorBarParameters::room() const {
  // From the left end of the bar's panel to the right end of the picture, or from its top to the bottom.
  constexpr float atRight = 0.14F, atBottom = 0.19F;
  if (!keepsRoom || placed) return glm::vec2(0);
  return horizontal ? glm::vec2(0, atBottom) : glm::vec2(atRight, 0);
}

std::filesystem::path ColorBarParameters::fontFile() const {
  return font.empty() ? assetFolder() / "fonts" / "OpenSans-Regular.ttf" : font;
}

void ColorBarParameters::ports(Ports& ports) const {
  if (!of.empty()) ports.requireFrom<ColorScale>(of, {"of"}, When::afterFrame);
}

std::vector<BarTick> barTicks(double first, double last, int count) {
  const double span = std::abs(last - first);
  if (!(span > 0) || !std::isfinite(span)) return {{0, fmt::format("{:g}", first)}};
  const double rough = span / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double ratio = rough / power;
  const double step = power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
  const double low = std::min(first, last);
  // Rounding errors may move a tick slightly beyond the end of the range.
  const double slack = 1e-6 * step;
  const bool scientific = std::max(std::abs(first), std::abs(last)) >= 1e5 || step < 1e-4;
  const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  std::vector<BarTick> ticks;
  for (double i = std::ceil((low - slack) / step); i * step <= low + span + slack; ++i) {
    const double value = i == 0 ? 0 : i * step;  // avoids a negative zero as the first value
    ticks.push_back({(value - first) / (last - first),
                     scientific ? fmt::format("{:.3g}", value) : fmt::format("{:.{}f}", value, digits)});
  }
  return ticks;
}

}  // namespace simreel::sim
