// Tests the drawing of water: shores, and the colours of the ground.
#include "reference/water_twin.hpp"
#include "sim/water/ground.hpp"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/gtc/packing.hpp>

using namespace simreel;

namespace {

/// Returns a lake at level 0 on a beach that rises by `slope` along x and by half of `slope` along z.
WaterTwin beach(double slope) {
  sim::WaterParameters p;
  p.size = {65, 9};
  p.cell = 0.1F;
  p.bed = -1;
  WaterTwin twin(sim::WaterPlan(p, "lake", 1, 1.0 / 30));
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 65; ++x) {
      const auto bed = static_cast<float>(slope * (0.1 * (x - 32) + 0.05 * (y - 4)));
      twin.cells[static_cast<std::size_t>(y * 65 + x)] = {std::max(0.0F, bed), 0, 0, bed};
    }
  return twin;
}

}  // namespace

TEST_CASE("a lake's shore on a plane beach is a straight line within a third of a cell") {
  for (const double slope : {0.05, 0.2, 0.8}) {
    CAPTURE(slope);
    const WaterTwin twin = beach(slope);
    const std::vector<glm::vec4> shown = twin.look();
    double first = 0, last = 0, worst = 0;
    std::vector<double> shore;
    for (int y = 0; y < 9; ++y) {
      double found = -1;
      for (int x = 0; x + 1 < 65; ++x) {
        const auto above = [&](int i) {
          const auto at = static_cast<std::size_t>(y * 65 + i);
          return static_cast<double>(shown[at].y) - static_cast<double>(twin.cells[at].w);
        };
        if (above(x) > 0 && above(x + 1) <= 0) found = x + above(x) / (above(x) - above(x + 1));
      }
      shore.push_back(found);
    }
    first = shore.front();
    last = shore.back();
    for (int y = 0; y < 9; ++y)
      worst =
          std::max(worst, std::abs(shore[static_cast<std::size_t>(y)] - (first + (last - first) * y / 8)));
    CHECK(std::abs(last - first + 4) < 0.5);  // In this direction, the beach is half as steep.
    CHECK(worst < (slope < 0.1 ? 0.33 : 0.15));
  }
}

TEST_CASE("wet ground is darker, and its colours are all in the palette") {
  sim::WaterParameters p;
  p.size = {65, 33};
  p.bed = 0.3F;
  p.hills = {{glm::vec3(0), {1, 0, 1}, -0.8F}};
  const sim::WaterPlan plan(p, "pond", 1, 1.0 / 30);
  const auto colors = sim::groundColors(plan);
  const auto palette = sim::groundPalette(plan);
  REQUIRE(colors.size() == 65 * 33 + 1);
  double wet = 0, dry = 0;
  int wets = 0, dries = 0;
  for (std::size_t i = 0; i < plan.firstCells().size(); ++i) {
    const auto number = static_cast<std::size_t>(glm::unpackHalf1x16(colors[i]));
    REQUIRE(number < palette.size());
    const glm::vec4 cell = plan.firstCells()[i];
    const bool under = cell.x > cell.w;
    (under ? wet : dry) += static_cast<double>(palette[number].x);
    ++(under ? wets : dries);
  }
  REQUIRE(wets > 50);
  REQUIRE(dries > 50);
  CHECK(wet / wets < 0.7 * dry / dries);
}

namespace water_look_help {

/// Returns a lake at level 0 beside rock that rises by 0.6 m a cell of 0.5 m. `film`: depth in metres of
/// the water that a wave has left in every third cell of the first row of rock above the lake.
WaterTwin rock(float film) {
  sim::WaterParameters p;
  p.size = {12, 24};
  p.cell = 0.5F;
  p.bed = -3;
  p.foam = 2;
  WaterTwin twin(sim::WaterPlan(p, "lake", 1, 1.0 / 30));
  for (int y = 0; y < p.size.y; ++y)
    for (int x = 0; x < p.size.x; ++x) {
      const float bed = std::max(-3.0F, 0.6F * static_cast<float>(x) - 3.1F);
      const float depth = x == 6 && y % 3 == 1 ? film : 0.0F;
      twin.cells[static_cast<std::size_t>(y * p.size.x + x)] = {std::max(0.0F, bed + depth), 0, 0, bed};
    }
  return twin;
}

}  // namespace water_look_help

TEST_CASE("films that waves leave on steep rock make no peaks beside a lake") {
  for (const float film : {0.0F, 0.03F, 0.1F, 0.2F}) {
    CAPTURE(film);
    const WaterTwin twin = water_look_help::rock(film);
    const std::vector<glm::vec4> shown = twin.look();
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const float bed = twin.cells[i].w;
      if (bed > 0) CHECK(shown[i].y < bed);                      // The rock hides every film.
      if (bed < 0) CHECK(shown[i].y == 0);                       // The lake is drawn at its own level.
      if (i % 12 == 6) CHECK(shown[i].y < 0.7F * (bed + film));  // The shore stays near the lake's level.
    }
  }
}

TEST_CASE("foam at a single steep cell spreads smoothly over its neighbours") {
  WaterTwin twin = water_look_help::rock(0);
  twin.cells[12 * 12 + 1].x = 0.4F;
  twin.cells[12 * 12 + 2].x = 0.4F;
  const std::vector<glm::vec4> shown = twin.look();
  const auto foam = [&](int x, int y) {
    return static_cast<int>(shown[static_cast<std::size_t>(y * 12 + x)].w) / shader::depthColors;
  };
  CHECK(foam(2, 8) == 0);
  for (int y = 9; y < 16; ++y)
    for (int x = 0; x < 4; ++x) {
      CAPTURE(x);
      CAPTURE(y);
      CHECK(std::abs(foam(x, y) - foam(x, y - 1)) <= shader::foamColors / 2);
    }
  CHECK(foam(2, 11) > shader::foamColors / 4);
}

TEST_CASE("water thinner than 1/200 of the greatest depth has no foam") {
  for (const float depth : {0.01F, 0.2F}) {
    CAPTURE(depth);
    WaterTwin twin = water_look_help::rock(0);
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 5; ++x) {
        const float bed = y == 12 && (x == 1 || x == 2) ? 0.4F : 0.0F;
        twin.cells[static_cast<std::size_t>(y * 12 + x)] = {bed + depth, 0, 0, bed};
      }
    const auto shown = twin.look();
    CHECK((static_cast<int>(shown[12 * 12 + 2].w) / shader::depthColors > 0) == (depth > 0.015F));
  }
}
