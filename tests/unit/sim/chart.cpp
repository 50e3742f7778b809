// Tests charts of measured quantities: axes with round numbers, and valid settings.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "sim/chart/parameters.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"

#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;
using simreel::test::checkHas;

TEST_CASE("chart: axis scales are round, contain their values and are as narrow as possible") {
  struct Known {
    double minimum, maximum, low, high;
  };
  for (const Known& known : {Known{0, 1, 0, 1},
                             {0.1, 1.9, 0, 2},
                             {-3, 17, -10, 20},
                             {0, 0.07, 0, 0.08},
                             {1234, 1260, 1230, 1260},
                             {5, 5, 2, 8},
                             {0, 0, 0, 1}}) {
    CAPTURE(known.minimum);
    CAPTURE(known.maximum);
    const sim::ChartRange range = sim::roundRange(known.minimum, known.maximum);
    CHECK(range.low == doctest::Approx(known.low));
    CHECK(range.high == doctest::Approx(known.high));
  }
  double minimum = 1e-9, maximum = 1.3e-9;
  for (int i = 0; i < 200; ++i) {
    const sim::ChartRange range = sim::roundRange(-minimum, maximum);
    CHECK(range.low <= -minimum * (1 - 1e-12));
    CHECK(range.high >= maximum * (1 - 1e-12));
    CHECK(range.high - range.low < 3 * (minimum + maximum));
    minimum *= 1.37;
    maximum *= 1.21;
  }
}

TEST_CASE("chart: errors in charts are reported") {
  const auto mistakeOf = [](const std::string& chart) {
    try {
      static_cast<void>(scene::parseScene(
          fmt::format(R"({{"version": 1, "objects": {{"flag": {{"cloth": {{}}}}, "c": {{"chart": {}}}}}}})",
                      chart),
          "scene.json", {}, sim::kinds()));
    } catch (const UserError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  checkHas(mistakeOf(R"({"curves": [{"of": "flag.kineticEnergy"}]})"), "none");
  checkHas(mistakeOf("{}"), "a chart needs \"curves\"");
  checkHas(mistakeOf(R"({"curves": [{"of": "flag"}]})"), "as \"OBJECT.QUANTITY\", not \"flag\"");
  checkHas(mistakeOf(R"({"curves": [{"of": "flag.kinetic"}]})"), "has no quantity \"flag.kinetic\"");
  checkHas(mistakeOf(R"({"curves": [{"of": "fag.kineticEnergy"}]})"), "no object is named \"fag\"");
  checkHas(mistakeOf(R"({"curves": [{"of": "flag.kineticEnergy"}], "low": 1, "high": 1})"),
           "\"high\" is not above \"low\"");
}
