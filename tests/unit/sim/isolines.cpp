#include "base/error.hpp"
#include "scene/load.hpp"
#include "sim/isolines/labels.hpp"
#include "sim/isolines/lines.hpp"
#include "sim/isolines/parameters.hpp"
#include "sim/scale_bar/parameters.hpp"
#include "sim/world/list.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel::sim;

namespace {

/// Returns samples of a function of the position (pixels), one per pixel.
template <class Function>
IsoGrid sampled(glm::ivec2 size, Function function) {
  IsoGrid grid;
  grid.size = size;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) grid.values.push_back(function(x, y));
  return grid;
}

const glm::dvec4 whole(0, 0, 100, 100);

double areaOf(const std::vector<std::vector<glm::dvec2>>& outlines) {
  double twice = 0;
  for (const auto& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      twice += a.x * b.y - b.x * a.y;
    }
  return 0.5 * twice;
}

std::vector<std::string> textsOf(const std::vector<IsoLevel>& levels) {
  std::vector<std::string> texts;
  for (const IsoLevel& level : levels) texts.push_back(level.text);
  return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE(
    "isolines of a cone are circles about its axis, and their outlines have their length times the width") {
  const IsoGrid grid = sampled({100, 100}, [](double x, double y) { return std::hypot(x - 50, y - 47); });
  const std::vector<double> levels = {10, 30};
  const std::vector<IsoLine> lines = isoLines(grid, levels, whole);
  REQUIRE(lines.size() == 2);
  for (const IsoLine& line : lines) {
    CHECK(line.closed);
    const double radius = levels[static_cast<std::size_t>(line.level)];
    for (const glm::dvec2& point : line.points)
      CHECK(std::abs(glm::distance(point, glm::dvec2(50, 47)) - radius) < 0.02);
    CHECK(std::abs(areaOf(isoStroke(line, 2))) == doctest::Approx(4 * 3.14159265 * radius).epsilon(0.01));
  }
  // Both outlines have the same orientation, so that touching outlines add up.
  CHECK(areaOf(isoStroke(lines[0], 2)) * areaOf(isoStroke(lines[1], 2)) > 0);
}

TEST_CASE("isolines end at the part that is shown and at missing values") {
  IsoGrid grid = sampled({100, 100}, [](double x, double /*y*/) { return x; });
  std::vector<IsoLine> lines = isoLines(grid, std::vector<double>{30.25}, {0, 20, 100, 80});
  REQUIRE(lines.size() == 1);
  CHECK_FALSE(lines[0].closed);
  CHECK(glm::distance(lines[0].points.front(), lines[0].points.back()) == doctest::Approx(60));
  for (const glm::dvec2& point : lines[0].points) CHECK(point.x == doctest::Approx(30.25));
  grid.values[50 * 100 + 30] = std::numeric_limits<double>::quiet_NaN();
  lines = isoLines(grid, std::vector<double>{30.25}, whole);
  CHECK(lines.size() == 2);
}

TEST_CASE("a saddle is cut as the mean of its corners says") {
  IsoGrid grid;
  grid.size = {2, 2};
  grid.values = {1, 0, 0, 0.9};  // The mean is below 0.5, so the contour cuts off both high corners.
  std::vector<IsoLine> lines = isoLines(grid, std::vector<double>{0.5}, whole);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].points.front().x + lines[0].points.back().y < 1.1);
  grid.values = {1, 0.2, 0.2, 0.9};  // The mean is above 0.5, so the contour cuts off both low corners.
  lines = isoLines(grid, std::vector<double>{0.5}, whole);
  REQUIRE(lines.size() == 2);
  for (const IsoLine& line : lines) {
    const glm::dvec2 middle = 0.5 * (line.points.front() + line.points.back());
    CHECK((middle.x - 0.5) * (middle.y - 0.5) < 0);
  }
}

TEST_CASE("samples of a magnified field follow a cubic between the middles of cells") {
  std::vector<float> values;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 12; ++x) values.push_back(static_cast<float>((x + 0.5) * (x + 0.5)));
  const IsoGrid grid = isoGrid(values, {12, 8}, {{0, 0, 120, 80}, {0, 0}, {0.1, 0.1}});
  CHECK(grid.size == glm::ivec2(61, 41));
  CHECK(grid.spacing.x == doctest::Approx(2));
  for (int x = 15; x <= 45; ++x)  // The tested samples are away from the edges.
    CHECK(grid.values[static_cast<std::size_t>(20 * 61 + x)] == doctest::Approx(0.04 * x * x));
}

TEST_CASE("numbers are upright, away from each other, and leave a gap in their line") {
  const IsoGrid grid = sampled({300, 200}, [](double x, double y) { return std::hypot(x - 150, y - 100); });
  const glm::dvec4 part(0, 0, 300, 200);
  const std::vector<double> levels = {40, 60, 80};
  const std::vector<IsoLine> lines = isoLines(grid, levels, part);
  REQUIRE(lines.size() == 3);
  const IsoLabelSizes sizes{{20, 20, 0}, 8};
  const std::vector<IsoLabel> labels = placeLabels(lines, sizes, part);
  REQUIRE(labels.size() == 2);
  for (const IsoLabel& label : labels) {
    CHECK(lines[label.line].level < 2);
    CHECK(label.along.x >= 0);
    const double radius = levels[static_cast<std::size_t>(lines[label.line].level)];
    CHECK(std::abs(glm::distance(label.middle, glm::dvec2(150, 100)) - radius) < 2);
    double rest = 0;
    for (const IsoLine& piece : withoutLabels(lines[label.line], std::vector<IsoLabel>{label}, 8))
      for (std::size_t i = 1; i < piece.points.size(); ++i)
        rest += glm::distance(piece.points[i - 1], piece.points[i]);
    CHECK(rest == doctest::Approx(2 * 3.14159265 * radius - (20 + 2 * 0.45 * 8)).epsilon(0.01));
  }
  CHECK(glm::distance(labels[0].middle, labels[1].middle) > 20);
}

TEST_CASE("levels of isolines are multiples between the extremes of the values") {
  IsolineParameters parameters;
  parameters.of = "hill";
  parameters.every = 0.1;
  parameters.bold = 2;
  const std::vector<IsoLevel> levels = parameters.levels({0, 1}, {-0.05, 0.32});
  CHECK(textsOf(levels) == Texts{"0.0", "0.1", "0.2", "0.3"});
  CHECK(levels[2].bold);
  CHECK_FALSE(levels[1].bold);
  parameters.every.reset();
  parameters.unit = "m";
  CHECK(textsOf(parameters.levels({0, 430}, {40, 160})) == Texts{"50 m", "100 m", "150 m"});
}

TEST_CASE("isolines take their values from a field or from a terrain") {
  const auto mistake = [](const std::string& members) -> std::string {
    try {
      static_cast<void>(simreel::scene::parseScene(
          R"({"version": 2, "objects": {"sea": {"water": {}}, "ball": {"sphere": {}}, "l": {"isolines": {)" +
              members + "}}}}",
          "scene.json", {}, kinds()));
    } catch (const simreel::UserError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(mistake(R"("terrain": "sea", "every": 0.1)").empty());
  CHECK(mistake("").find("lines of which values?") != std::string::npos);
  CHECK(mistake(R"("of": "sea", "terrain": "sea")").find("leave out one of both") != std::string::npos);
  CHECK(mistake(R"("terrain": "ball")").find("has no surface for lines") != std::string::npos);
  // Water has a field, but shows it only with another "layer".
  CHECK(mistake(R"("of": "sea")").find("scene.json:1:") != std::string::npos);
  CHECK(mistake(R"("of": "sea")").find("shows no field over the picture") != std::string::npos);
  CHECK(mistake(R"("terrain": "sea", "scale": 0)").find("the same value") != std::string::npos);
}

TEST_CASE("scale bars have round lengths that fit") {
  CHECK(roundLength(2.4, "m").text == "2 m");
  CHECK(roundLength(5, "m").text == "5 m");
  CHECK(roundLength(0.0999, "m").text == "5 cm");
  CHECK(roundLength(1e-3, "m").text == "1 mm");
  CHECK(roundLength(999, "m").text == "500 m");
  CHECK(roundLength(70e3, "m").text == "50 km");
  CHECK(roundLength(33, "cells").text == "20 cells");
  CHECK(roundLength(33, "cells").length == doctest::Approx(20));
  CHECK(givenLength(1500, "m").text == "1.5 km");
}
