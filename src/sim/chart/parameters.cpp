#include "sim/chart/parameters.hpp"

#include "sim/ports/measured.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr scene::Range anyValue{-1e12, 1e12};

}  // namespace

std::string ChartParameters::Curve::object() const {
  return of.substr(0, of.rfind('.'));
}

std::string ChartParameters::Curve::quantity() const {
  return of.substr(of.rfind('.') + 1);
}

void ChartParameters::describe(scene::Fields& f) {
  f.list(
      "curves", curves, "Curves that are drawn, a value each frame, from time 0 on.",
      [](scene::Fields& c, Curve& curve) {
        c.text("of", curve.of, "OBJECT.QUANTITY, as \"checks\" know it.");
        c.text("label", curve.label, "Name of the curve on the chart; ASCII.");
        c.leftOut("label", "the quantity");
        c.number("per", curve.per, {1e-12, 1e12}, "", "Value that the chart shows as 1.");
        glm::vec3 color = curve.color.value_or(glm::vec3(0));
        c.color("color", color, scene::fraction, "Colour of the curve, linear RGB.");
        c.leftOut("color", "orange, blue, green, violet");
        if (c.given("color")) curve.color = color;
        const std::size_t point = curve.of.rfind('.');
        if (point == std::string::npos || point == 0 || point + 1 == curve.of.size())
          c.error("of", fmt::format("say which quantity of which object as \"OBJECT.QUANTITY\", not \"{}\"",
                                    curve.of));
      },
      maxCurves);
  f.optionalNumber("low", low, anyValue, "", "Value at the foot of the chart.");
  f.leftOut("low", "a round number below what was so far");
  f.optionalNumber("high", high, anyValue, "", "Value at the top of the chart, greater than \"low\".");
  f.leftOut("high", "a round number above what was so far");
  if (low && high && !(*low < *high)) f.error("high", "\"high\" is not above \"low\"");
  f.number("seconds", seconds, {0, 1e6}, "s",
           "Length of its time axis, which grows beyond that when needed.");
  f.number("x", x, {-10, 10}, "",
           "Where its left side is: fraction of the picture's width, from the left.");
  f.number("y", y, {-10, 10}, "", "Place of its top, as a fraction of the picture's height, from the top.");
  f.number("width", width, {0.01, 10}, "", "Width as a fraction of the picture's.");
  f.number("height", height, {0.01, 10}, "", "Height as a fraction of the picture's.");
  const auto hold = [&](const char* key, float first, float size) {
    if (first >= 1 || first + size <= 0)
      f.error(key,
              fmt::format("the chart lies outside of the picture: it reaches from {:g} to {:g}, and the "
                          "picture from 0 to 1",
                          first, first + size));
  };
  hold("x", x, width);
  hold("y", y, height);
  if (curves.empty()) f.error("curves", "a chart needs \"curves\": [{\"of\": \"OBJECT.QUANTITY\"}]");
}

void ChartParameters::ports(Ports& ports) const {
  for (const Curve& curve : curves) ports.requireFrom<Measured>(curve.of, {"curves"});
}

ChartRange roundRange(double minimum, double maximum) {
  const double size = std::max(std::abs(minimum), std::abs(maximum));
  if (!(maximum - minimum > std::max(1e-9 * size, 1e-30))) {
    if (size < 1e-30) return {0, 1};
    const double around = 0.5 * size;
    minimum -= around;
    maximum += around;
  }
  // Finds the minimum step for which the limits are at most four steps apart. Powers of ten are computed by
  // multiplication.
  double decade = 1;
  while (decade * 10 <= maximum - minimum) decade *= 10;
  while (decade > maximum - minimum) decade /= 10;
  decade /= 10;
  for (;; decade *= 10)
    for (const double step : {decade, 2 * decade, 5 * decade}) {
      const double low = std::floor(minimum / step), high = std::ceil(maximum / step);
      if (high - low <= 4) return {low * step, high * step};
    }
}

}  // namespace simreel::sim
