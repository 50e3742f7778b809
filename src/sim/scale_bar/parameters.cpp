#include "sim/scale_bar/parameters.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "sim/ports/field_source.hpp"

#include <cmath>

#include <fmt/format.h>

namespace simreel::sim {

ScaleLength givenLength(double length, const std::string& unit) {
  struct Prefix {
    double metres;
    const char* unit;
  };
  constexpr Prefix prefixes[] = {{1e3, "km"},  {1, "m"},     {1e-2, "cm"},
                                 {1e-3, "mm"}, {1e-6, "um"}, {1e-9, "nm"}};
  constexpr double slack = 1 - 1e-9;
  if (unit == "m")
    for (const Prefix& prefix : prefixes)
      if (length >= slack * prefix.metres || prefix.metres == 1e-9)
        return {length, fmt::format("{:.6g} {}", length / prefix.metres, prefix.unit)};
  return {length, fmt::format("{:.6g}{}{}", length, unit.empty() ? "" : " ", unit)};
}

ScaleLength roundLength(double most, const std::string& unit) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  constexpr double slack = 1 + 1e-9;
  double length = power;
  for (const double times : {2.0, 5.0, 10.0})
    if (times * power <= most * slack) length = times * power;
  return givenLength(length, unit);
}

void ScaleBarParameters::describe(scene::Fields& f) {
  f.text("of", of, "Field whose cells it measures: NAME or NAME.PART.");
  f.leftOut("of", "nothing: it measures metres in the picture of the camera");
  f.number("cell", cell, scene::positive, "", "Size of a cell of the field, in \"unit\".");
  f.text("unit", unit, "Unit of lengths; metres are written as km, m, cm or mm.");
  f.leftOut("unit", "m; cells for a field without \"cell\"");
  f.optionalNumber("length", length, scene::positive, "", "Length of the bar, in \"unit\".");
  f.leftOut("length", "the greatest of 1, 2 or 5 times a power of ten that fits");
  f.number("most", most, {0.01, 1}, "", "Greatest length as a fraction of the picture's width.");
  f.vector("corner", corner, {-10, 10}, "", "Left end of the bar as fractions of the picture, [x, y, 0].");
  f.leftOut("corner", "[0.05,0.93,0]; in version 2 beside a chart that is there");
  moves = f.version() > 1 && !f.given("corner");
  f.number("height", height, {0.001, 1}, "",
           "Height of capital letters, as a fraction of the picture's height.");
  f.asset("font", font, "A TrueType or OpenType file.");
  f.leftOut("font", "Open Sans, which ships with simreel");
  f.color("color", color, scene::notNegative, "Colour of bar and number, linear RGB.");
  f.number("backdrop", backdrop, scene::fraction, "", "Opacity of the dark panel behind it.");
  f.idleUnless(!of.empty(), "of", {"cell"}, "a field, with \"of\"");
  f.idleUnless(!length.has_value(), "length", {"most"}, "a bar without \"length\"");
  if (!f.given("unit")) unit = of.empty() || f.given("cell") ? "m" : "cells";
  if (!isUtf8(unit)) f.error("unit", "the text is not UTF-8");
  if (of.empty() && unit != "m")
    f.error("unit", "the camera's picture is measured in m; another \"unit\" needs \"of\", a field");
}

std::filesystem::path ScaleBarParameters::fontFile() const {
  return font.empty() ? assetFolder() / "fonts" / "OpenSans-Regular.ttf" : font;
}

void ScaleBarParameters::moveAside(const std::vector<scene::PictureArea>& taken) {
  if (!moves) return;
  constexpr float apart = 0.03F;  // distance of the bar's panel from a chart
  for (const scene::PictureArea& area : taken) {
    const bool beside = corner.x > area.to.x || corner.x + most < area.from.x;
    if (beside || corner.y - 2 * height > area.to.y || corner.y < area.from.y) continue;
    if (area.to.x + apart + most < 1)
      corner.x = area.to.x + apart;
    else
      corner.y = area.from.y - apart;
  }
}

void ScaleBarParameters::ports(Ports& ports) const {
  ports.want<FieldSource>(of, {"of"});
}

}  // namespace simreel::sim
