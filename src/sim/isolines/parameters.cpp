#include "sim/isolines/parameters.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "scene/covering.hpp"
#include "sim/ports/field_source.hpp"
#include "sim/ports/landform.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Port of objects that publish a field and draw it over the picture or behind it.
struct ShownField {
  static const PortInfo port;
};

constinit const PortInfo ShownField::port = {
    .name = "shown field",
    .lacks =
        ", which shows no field over the picture, so the lines have no place; give a field "
        "\"display\": {\"layer\": \"over\"}",
    .none = "the scene shows no field",
    .when = When::afterFrame,
    .part = "field",
    .implied =
        [](const scene::Object& provider, std::vector<std::string>& parts) {
          const auto* covering = dynamic_cast<const scene::Covering*>(provider.parameters.get());
          if (covering != nullptr && covering->covering() == scene::Covering::Extent::none) return false;
          for (const Ports::Offer& offer : portsOf(provider).offers)
            if (offer.port == &FieldSource::port && offer.given) {
              parts = offer.parts;
              return true;
            }
          return false;
        },
};

}  // namespace

void IsolineParameters::describe(scene::Fields& f) {
  f.text("of", of,
         "Field whose values the lines join: NAME or NAME.PART. They lie over the display of that object.");
  f.text(
      "terrain", terrain,
      "Object whose heights the lines join, on its surface in the world, instead of \"of\": a mesh, water "
      "(its ground), or kernels with a \"terrain\".");
  f.number("scale", scale, scene::anyNumber, "1/m", "Change of the value with the height, on a terrain.");
  f.number("zero", zero, scene::anyNumber, "", "Value at the height 0, on a terrain.");
  f.optionalNumber("every", every, scene::positive, "", "Distance between the values of two lines.");
  f.leftOut(
      "every",
      "a round number that gives about ten lines in the range of the field's colours, or of the heights");
  f.formula("at", at, "", "Values of the lines instead: a list of numbers.");
  f.leftOut("at", "multiples of \"every\"");
  f.integer("bold", bold, {0, 100}, "",
            "Each line whose multiple of \"every\" this divides is thick, and "
            "only thick lines have numbers; 0: all lines are alike.");
  f.boolean("labels", labels, "Writes numbers on the lines.");
  f.text("unit", unit, "Unit after the numbers.");
  f.color("color", color, scene::notNegative, "Colour of lines and numbers, linear RGB.");
  f.leftOut("color", "[0.01,0.01,0.01]; in version 2 light over dark colours of the field");
  contrasts = f.version() > 1 && !f.given("color");
  f.number("opacity", opacity, scene::fraction, "", "Opacity of lines and numbers.");
  f.number(
      "width", width, {1e-4, 0.1}, "",
      "Width of a line, as a fraction of the picture's height, or of the terrain's longer side; thick ones "
      "are twice as wide.");
  f.number(
      "height", height, {0.001, 1}, "",
      "Height of capital letters, as a fraction of the picture's height, or of the terrain's longer side.");
  f.asset("font", font, "A TrueType or OpenType file.");
  f.leftOut("font", "Open Sans, which ships with simreel");
  f.idleUnless(labels, "labels", {"unit", "height", "font"}, "\"labels\": true");
  f.idleUnless(at.empty(), "at", {"bold"}, "multiples of \"every\"");
  if (of.empty() && terrain.empty())
    f.error("of", "lines of which values? Give \"of\", the name of a field, or \"terrain\"");
  if (!of.empty() && !terrain.empty())
    f.error("terrain", "\"of\" names the values already; leave out one of both");
  f.idleUnless(!terrain.empty(), "terrain", {"scale", "zero"}, "lines on a \"terrain\"");
  f.idleUnless(terrain.empty(), "terrain", {"opacity"}, "lines over a field");
  if (scale == 0) f.error("scale", "with 0 all heights have the same value");
  if (every && !at.empty()) f.error("at", "\"every\" gives the values already; leave out one of both");
  if (at.moving || std::any_of(at.parts.begin(), at.parts.end(),
                               [](const scene::Formula::Part& part) { return !part.text.empty(); }))
    f.error("at", "expected numbers, such as [0.1, 0.5]");
  if (!isUtf8(unit)) f.error("unit", "the text is not UTF-8");
}

std::filesystem::path IsolineParameters::fontFile() const {
  return font.empty() ? assetFolder() / "fonts" / "OpenSans-Regular.ttf" : font;
}

void IsolineParameters::ports(Ports& ports) const {
  if (!of.empty()) ports.requireFrom<ShownField>(of, {"of"}, When::afterFrame);
  if (!terrain.empty()) ports.requireFrom<Landform>(terrain, {"terrain"}, When::afterFrame);
}

namespace {

/// Returns 1, 2 or 5 times a power of ten near `rough`.
double roundStep(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double ratio = rough / power;
  return power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
}

/// Returns the number of decimals that show multiples of `step` exactly, at most 6.
int decimalsOf(double step) {
  int digits = 0;
  for (double scaled = step; digits < 6 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled; ++digits)
    scaled *= 10;
  return digits;
}

}  // namespace

std::vector<IsoLevel> IsolineParameters::levels(glm::dvec2 colors, glm::dvec2 values) const {
  std::vector<IsoLevel> all;
  const std::string after = unit.empty() ? "" : " " + unit;
  if (!at.empty()) {
    for (const scene::Formula::Part& part : at.parts)
      all.push_back({part.number, fmt::format("{:g}{}", part.number, after), false});
    std::sort(all.begin(), all.end(),
              [](const IsoLevel& a, const IsoLevel& b) { return a.value < b.value; });
    return all;
  }
  const double span = std::abs(colors.y - colors.x);
  if (!(values.x <= values.y) || !(span > 0)) return all;
  const double step = every.value_or(roundStep(span / 10));
  const double first = std::ceil(values.x / step), last = std::floor(values.y / step);
  if (last - first >= maxIsoLevels)
    fail(ExitCode::usage,
         "isolines of \"{}\": {:.0f} lines between {:g} and {:g}, at most {}; raise \"every\"",
         of.empty() ? terrain : of, last - first + 1, values.x, values.y, maxIsoLevels);
  const int digits = decimalsOf(step);
  for (double i = first; i <= last; ++i) {
    const double value = i == 0 ? 0 : i * step;
    const bool large = std::abs(value) >= 1e6;
    all.push_back(
        {value,
         large ? fmt::format("{:g}{}", value, after) : fmt::format("{:.{}f}{}", value, digits, after),
         bold > 0 && std::fmod(i, bold) == 0});
  }
  return all;
}

}  // namespace simreel::sim
