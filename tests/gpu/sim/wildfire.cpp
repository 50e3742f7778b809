#include "base/error.hpp"
#include "gpu/sim/spread.hpp"
#include "unit/help.hpp"

#include <cmath>

#include <doctest/doctest.h>

namespace simreel::test::wildfire_sim {

namespace {

using Parameters = sim::WildfireParameters;

Parameters plain(int width, int height) {
  Parameters p;
  p.size = {width, height};
  p.stepsPerSecond = 90;
  p.spread = 0.2F;
  p.patchiness = 0;
  p.burnSteps = 9;
  p.coolSteps = 30;
  p.strokes = {spread::dot({0.5F * static_cast<float>(width), 0.5F * static_cast<float>(height), 0}, 2)};
  return p;
}

void compare(const Parameters& parameters, int frames) {
  const auto gpu = spread::make(sim::wildfireKind(), parameters);
  WildfireTwin twin(sim::WildfirePlan(parameters, "field", 5, spread::frameSeconds));
  const auto start = twin.cells;
  CHECK(spread::rowsOf(*gpu) == twin.counts);
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(frame * spread::frameSeconds, {});
    twin.step(frame * spread::frameSeconds);
    const auto rows = spread::rowsOf(*gpu);
    CHECK(
        std::equal(rows.begin(), rows.end(), twin.counts.end() - static_cast<std::ptrdiff_t>(rows.size())));
  }
  const auto got = gpu->state()[0].buffer->readAll<glm::uvec4>();
  CHECK(got == sim::packedCells(twin.cells, parameters.size));
  CHECK(twin.cells != start);
}

/// Replaces all strokes by strokes that light row `first` and every `each`-th row after it.
void lightRows(Parameters& p, int first, int each) {
  p.strokes.clear();
  for (int y = first; y < p.size.y; y += each) {
    const float middle = static_cast<float>(y) + 0.5F;
    auto line = spread::dot({-1, middle, 0}, 0.4F);
    line.shape = sim::StrokeParameters::Shape::line;
    line.to = {static_cast<float>(p.size.x) + 1, middle, 0};
    p.strokes.push_back(line);
  }
}

struct Scar {
  double x = 0, y = 0;  ///< mean position of burning and burnt cells relative to the grid's centre, in
                        ///< cells
  int cells = 0;
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};

Scar burn(const Parameters& p, int frames, int seed = 5) {
  const auto gpu = spread::make(sim::wildfireKind(), p, seed);
  for (int frame = 0; frame < frames; ++frame) gpu->step(frame * spread::frameSeconds, {});
  const auto cells = spread::cellsOf(*gpu, p.size);
  Scar scar;
  for (int y = 0; y < p.size.y; ++y)
    for (int x = 0; x < p.size.x; ++x) {
      if (cells[static_cast<std::size_t>(y * p.size.x + x)] < 128) continue;
      ++scar.cells;
      scar.x += x + 0.5 - 0.5 * p.size.x;
      scar.y += y + 0.5 - 0.5 * p.size.y;
      scar.left = std::min(scar.left, x);
      scar.right = std::max(scar.right, x);
      scar.top = std::min(scar.top, y);
      scar.bottom = std::max(scar.bottom, y);
    }
  scar.x /= scar.cells;
  scar.y /= scar.cells;
  return scar;
}

}  // namespace

TEST_CASE("wildfire equals its CPU twin on 131x97, a torus with turning wind and embers") {
  auto p = plain(131, 97);
  p.border = Parameters::Border::torus;
  p.patchiness = 0.7;
  p.patchSize = 9;
  p.windDirection = scene::Animated<float>({{0.0, 20.0F}, {1.0, 200.0F}}, scene::Ease::linear);
  p.windStrength = 1.2F;
  p.embers = sim::Embers{0.01, 40, 0.5};
  compare(p, 40);
}

TEST_CASE("wildfire equals its CPU twin on 33x7, closed, with firebreaks and embers") {
  auto p = plain(33, 7);
  p.windStrength = 0.5F;
  p.moisture = 0.3F;
  p.embers = sim::Embers{0.0625, 9, 1};
  p.strokes.push_back(spread::dot({20, 0, 0}, 1, 0, 0.05));
  p.strokes.back().shape = sim::StrokeParameters::Shape::line;
  p.strokes.back().to = {24, 7, 0};
  p.strokes.push_back(spread::dot({30, 3, 0}, 2, 1, 0.3));
  compare(p, 30);
}

// Software drivers skip groups of cells that cannot change. In this test, most of the grid is in such
// groups: before the fire arrives (also across the borders of a torus), behind a firebreak until a stroke
// lights that side, and after all cells have burnt out.
TEST_CASE("wildfire equals its CPU twin on 331x211 with mostly unchanging cells") {
  for (const auto border : {Parameters::Border::torus, Parameters::Border::closed})
    for (const int frames : {7, 45, 120}) {
      CAPTURE(frames);
      auto p = plain(331, 211);
      p.border = border;
      p.spread = 0.6F;
      p.windStrength = 0.4F;
      p.strokes = {spread::dot({1, 1, 0}, 1.5F), spread::dot({160, -1, 0}, 1.5F, 0, 0.0),
                   spread::dot({250.5F, 100.5F, 0}, 2, 1, 2.0)};
      p.strokes[1].shape = sim::StrokeParameters::Shape::line;
      p.strokes[1].to = {170, 212, 0};
      compare(p, frames);
    }
}

TEST_CASE("wildfire equals its CPU twin on widths around 16 cells") {
  for (const int width : {3, 15, 16, 17, 32}) {
    auto p = plain(width, 5);
    p.border = Parameters::Border::torus;
    p.windStrength = 1;
    compare(p, 4);
  }
}

TEST_CASE("wildfire: cell counts add up, fuel only shrinks, burnt area only grows, and the fire ends") {
  const auto p = plain(131, 97);
  const auto gpu = spread::make(sim::wildfireKind(), p);
  glm::uvec4 last = spread::rowsOf(*gpu)[0];
  for (int frame = 0; frame < 150; ++frame) {
    gpu->step(frame * spread::frameSeconds, {});
    for (const glm::uvec4& row : spread::rowsOf(*gpu)) {
      REQUIRE(row.x + row.y + row.z + row.w == 131 * 97);
      REQUIRE(row.x <= last.x);
      REQUIRE(row.z >= last.z);
      REQUIRE(row.w == last.w);
      last = row;
    }
  }
  CHECK(last.y == 0);
  CHECK(last.z > 12000);
}

// A firebreak is two cells thick. Fire must not cross it, and bare cells must never change.
TEST_CASE("wildfire: bare ground never burns, and a firebreak holds") {
  auto p = plain(131, 97);
  p.spread = 1.0F;
  p.strokes[0].from = p.strokes[0].to = {20, 50, 0};
  p.strokes.push_back(spread::dot({65, -2, 0}, 1, 0));
  p.strokes.back().shape = sim::StrokeParameters::Shape::line;
  p.strokes.back().to = {65, 99, 0};
  const auto gpu = spread::make(sim::wildfireKind(), p);
  for (int frame = 0; frame < 100; ++frame) gpu->step(frame * spread::frameSeconds, {});
  const auto cells = spread::cellsOf(*gpu, p.size);
  int burnt = 0;
  for (int y = 0; y < 97; ++y)
    for (int x = 0; x < 131; ++x) {
      const int kind = cells[static_cast<std::size_t>(y * 131 + x)] >> 6;
      REQUIRE(kind == (x < 64 ? 3 : x < 66 ? 0 : 1));
      burnt += kind == 3 ? 1 : 0;
    }
  CHECK(burnt == 64 * 97);
}

TEST_CASE("wildfire: fire spreads equally to all sides without wind, and further downwind with wind") {
  auto p = plain(255, 255);
  p.spread = 0.12F;
  double x = 0;
  double y = 0;
  for (int seed = 1; seed <= 5; ++seed) {
    const Scar still = burn(p, 20, seed);
    x += still.x / 5;
    y += still.y / 5;
    CHECK(still.cells > 1000);
    CHECK(std::abs((still.right - still.left) - (still.bottom - still.top)) < 14);
  }
  CHECK(std::abs(x) < 2.5);
  CHECK(std::abs(y) < 2.5);
  p.windStrength = 1;
  for (const int direction : {0, 90, 180, 270}) {
    p.windDirection = static_cast<float>(direction);
    const Scar blown = burn(p, 20);
    const double along = direction == 0     ? blown.x
                         : direction == 90  ? -blown.y
                         : direction == 180 ? -blown.x
                                            : blown.y;
    const double aside = direction % 180 == 0 ? blown.y : blown.x;
    INFO("wind to ", direction, " degrees: ", along, " along, ", aside, " aside");
    CHECK(along > 8);
    CHECK(std::abs(aside) < 5);
  }
}

TEST_CASE("wildfire equals its CPU twin on 131x97 with hills") {
  auto p = plain(131, 97);
  p.border = Parameters::Border::torus;
  p.relief = 90;
  p.slope = 3;
  p.windStrength = 0.7F;
  p.windDirection = 130.0F;
  p.embers = sim::Embers{0.01, 20, 0.5};
  compare(p, 40);
  p.slope = 0.8;
  p.size = {47, 33};
  p.strokes[0].from = p.strokes[0].to = {20, 20, 0};
  compare(p, 20);
}

// The slope rises by half of the cell size per cell, in each of four directions. Fire must spread further
// uphill than downhill and equally far to both sides.
TEST_CASE("wildfire: fire spreads further uphill than downhill") {
  const auto rising = [](glm::ivec2 way) {  // White is 127.5 cell sizes higher than black.
    std::string pgm = "P5 255 255 255\n";
    for (int y = 0; y < 255; ++y)
      for (int x = 0; x < 255; ++x)
        pgm += static_cast<char>(way.x > 0 ? x : way.x < 0 ? 254 - x : way.y > 0 ? y : 254 - y);
    return pgm;
  };
  auto p = plain(255, 255);
  p.spread = 0.12F;
  p.relief = 127.5;
  p.slope = 2;
  for (const glm::ivec2 way : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
    const test::TemporaryFile terrain("terrain.pgm", rising(way));
    p.terrain = terrain.path();
    const Scar scar = burn(p, 20);
    const double up = scar.x * way.x + scar.y * way.y;
    const double aside = scar.x * way.y + scar.y * way.x;
    INFO("rising to ", way.x, " ", way.y, ": ", up, " up, ", aside, " aside");
    CHECK(up > 8);
    CHECK(std::abs(aside) < 5);
    auto even = p;
    even.slope = 0;
    const Scar ignored = burn(even, 20);
    CHECK(std::abs(ignored.x * way.x + ignored.y * way.y) < 5);
  }
}

// A plane rises by `tangent` per cell in the direction `way`, one of eight. Single burning cells form a
// lattice. In each direction, the fraction of neighbours that burns after one step must be the probability
// on even ground times e^(slope * tangent in that direction). The formula is written independently of the
// simulation's code.
TEST_CASE("wildfire: uphill spread grows by e^(slope * tangent) in all eight directions") {
  constexpr int side = 510;
  constexpr double spreads = 0.05;
  std::string dots = "P5 510 510 255\n";
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) dots += x % 4 == 2 && y % 4 == 2 ? '\xff' : '\0';
  const test::TemporaryFile lattice("dots.pgm", dots);
  auto p = plain(side, side);
  p.stepsPerSecond = 30;
  p.spread = static_cast<float>(spreads);
  p.strokes = {spread::dot({0, 0, 0}, 0)};
  p.strokes[0].shape = sim::StrokeParameters::Shape::image;
  p.strokes[0].image = lattice.path();
  struct Hill {
    double tangent, slope;
  };
  const glm::ivec2 around[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  for (const Hill hill : {Hill{0.5, 2}, Hill{1, 2}, Hill{2, 1}, Hill{4, 0.5}})
    for (const glm::ivec2 way : around) {
      // The map has 255 x 255 pixels with levels 0 to 254. Each pixel covers two cells.
      const bool diagonal = way.x != 0 && way.y != 0;
      std::string plane = "P5 255 255 255\n";
      for (int y = 0; y < 255; ++y)
        for (int x = 0; x < 255; ++x) {
          const int level = (way.x < 0 ? 254 - x : way.x * x) + (way.y < 0 ? 254 - y : way.y * y);
          plane += static_cast<char>(diagonal ? level / 2 : level);
        }
      const test::TemporaryFile terrain("plane.pgm", plane);
      p.terrain = terrain.path();
      p.slope = hill.slope;
      p.relief = hill.tangent * 2 * 255 * (diagonal ? std::sqrt(2.0) : 1);
      const auto gpu = spread::make(sim::wildfireKind(), p);
      gpu->step(0, {});
      const auto cells = spread::cellsOf(*gpu, p.size);
      for (const glm::ivec2 d : around) {
        double caught = 0;
        double all = 0;
        for (int y = 10; y < side - 8; y += 4)
          for (int x = 10; x < side - 8; x += 4, ++all)
            caught += cells[static_cast<std::size_t>((y + d.y) * side + x + d.x)] == 128 ? 1 : 0;
        const double length = std::hypot(d.x, d.y);
        const double rise = hill.tangent * (d.x * way.x + d.y * way.y) / length / std::hypot(way.x, way.y);
        const double chance = std::min(1.0, spreads / length * std::exp(hill.slope * rise));
        INFO("tangent ", hill.tangent, " towards ", way.x, " ", way.y, ", fire towards ", d.x, " ", d.y,
             ": ", caught / all, " against ", chance);
        CHECK(std::abs(caught - chance * all) <
              4 * std::sqrt(all * chance * (1 - chance)) + 0.01 * chance * all);
      }
    }
}

TEST_CASE("wildfire: embers cross a firebreak downwind") {
  auto p = plain(131, 97);
  p.strokes[0].from = p.strokes[0].to = {20, 50, 0};
  p.strokes.push_back(spread::dot({65, -2, 0}, 3, 0));
  p.strokes.back().shape = sim::StrokeParameters::Shape::line;
  p.strokes.back().to = {65, 99, 0};
  p.windStrength = 0.4F;
  CHECK(burn(p, 60).right < 66);
  p.embers = sim::Embers{0.01, 30, 0.3};
  CHECK(burn(p, 60).right > 80);
}

// A cell with full fuel and one burning neighbour must catch fire with probability `base`. For a diagonal
// neighbour, the probability is base / sqrt(2).
TEST_CASE("wildfire: the probability of catching fire is `spread`, weighted by fuel and moisture") {
  for (const double moisture : {0.0, 0.5}) {
    auto p = plain(900, 900);
    p.stepsPerSecond = 30;
    p.spread = 0.3F;
    p.moisture = static_cast<float>(moisture);
    lightRows(p, 1, 3);  // Each cell between the lit rows has three burning neighbours.
    const auto gpu = spread::make(sim::wildfireKind(), p);
    gpu->step(0, {});
    const auto cells = spread::cellsOf(*gpu, p.size);
    double caught = 0;
    for (int y = 0; y < 900; ++y)
      for (int x = 1; x < 899; ++x)
        if (y % 3 != 1 && cells[static_cast<std::size_t>(y * 900 + x)] == 128) ++caught;
    const double base = 0.3 * (1 - moisture);
    const double chance = 1 - (1 - base) * std::pow(1 - base / std::sqrt(2.0), 2);
    const double all = 600.0 * 898.0;
    CHECK(std::abs(caught - chance * all) < 4 * std::sqrt(all * chance * (1 - chance)));
  }
}

TEST_CASE("wildfire: a map without fuel is refused") {
  auto p = plain(33, 7);
  p.fuelLevel = 0;
  CHECK_THROWS_WITH_AS(spread::make(sim::wildfireKind(), p),
                       doctest::Contains("nothing on the wildfire's map"), UserError);
}

}  // namespace simreel::test::wildfire_sim
