#include "sim/strokes.hpp"

#include "base/error.hpp"
#include "source_folder.hpp"

#include <cmath>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::sim;

namespace {

using Brush = StrokeParameters::Shape;

StrokeParameters stroke(Brush shape, glm::vec3 from, glm::vec3 to, float radius) {
  StrokeParameters p;
  p.shape = shape;
  p.from = from;
  p.to = to;
  p.radius = radius;
  return p;
}

constexpr glm::ivec2 grid(61, 47);

/// Painted cells of the first step, and that none of them lies outside the box.
std::vector<glm::ivec2> painted(const Strokes& strokes, const shader::Stroke& s) {
  const glm::ivec4 box = Strokes::box(s, grid);
  CHECK(box.x >= 0);
  CHECK(box.y >= 0);
  CHECK(box.x + box.z <= grid.x);
  CHECK(box.y + box.w <= grid.y);
  std::vector<glm::ivec2> cells;
  for (int y = 0; y < grid.y; ++y)
    for (int x = 0; x < grid.x; ++x) {
      if (!strokes.paints(s, {x, y})) continue;
      cells.emplace_back(x, y);
      const bool inside = x >= box.x && x < box.x + box.z && y >= box.y && y < box.y + box.w;
      CHECK_MESSAGE(inside, x, " ", y);
    }
  return cells;
}

std::vector<glm::ivec2> paintedAtOnce(const StrokeParameters& p) {
  const Strokes strokes({p}, 1);
  const auto active = strokes.during(0, 0.1, 0);
  REQUIRE(active.size() == 1);
  return painted(strokes, active[0]);
}

/// Distance from the middle of a cell to a segment, in double.
double distance(glm::ivec2 cell, glm::dvec2 a, glm::dvec2 b) {
  const double px = cell.x + 0.5 - a.x;
  const double py = cell.y + 0.5 - a.y;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double along = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(px - along * dx, py - along * dy);
}

}  // namespace

TEST_CASE("a circle and a line paint the cells whose middle is within the radius") {
  struct {
    Brush shape;
    glm::dvec2 from, to;
    double radius;
  } const cases[] = {
      {Brush::circle, {30.3, 20.1}, {30.3, 20.1}, 7.2}, {Brush::line, {5.7, 40.2}, {55.1, 3.9}, 3.3},
      {Brush::line, {-20, 10}, {90, 10}, 0.7},          {Brush::circle, {0, 0}, {0, 0}, 11.9},
      {Brush::line, {12.4, 13.6}, {12.4, 13.6}, 2.6},   {Brush::circle, {500, 500}, {500, 500}, 30}};
  for (const auto& c : cases) {
    const auto cells = paintedAtOnce(
        stroke(c.shape, glm::vec3(c.from, 0), glm::vec3(c.to, 0), static_cast<float>(c.radius)));
    std::vector<glm::ivec2> expected;
    for (int y = 0; y < grid.y; ++y)
      for (int x = 0; x < grid.x; ++x)
        if (distance({x, y}, c.from, c.to) <= c.radius) expected.emplace_back(x, y);
    CHECK(cells == expected);
  }
}

TEST_CASE("a stroke of no duration paints in exactly one step, at any rate and from any start") {
  for (const double rate : {10.0, 7.0, 60.0, 29.97})
    for (const double at : {0.0, 0.1, 0.25, 0.7, 1.0, -0.3, 2.999}) {
      auto p = stroke(Brush::circle, {5, 5, 0}, {5, 5, 0}, 2);
      p.at = p.until = at;
      const Strokes strokes({p}, 1);
      int times = 0;
      long when = 0;
      for (long step = -100; step < 400; ++step)
        if (!strokes.during(static_cast<double>(step) / rate, 1 / rate, step).empty()) {
          ++times;
          when = step;
        }
      CHECK(times == 1);
      CHECK(when == static_cast<long>(std::floor(at * rate + 1e-6)));
    }
}

TEST_CASE("a long stroke paints in every step that it touches and no other") {
  auto p = stroke(Brush::line, {5, 5, 0}, {9, 5, 0}, 2);
  p.at = 0.35;
  p.until = 0.8;
  const Strokes strokes({p}, 1);
  for (int step = 0; step < 20; ++step)
    CHECK(strokes.during(step * 0.1, 0.1, step).size() == (step >= 3 && step < 8 ? 1 : 0));
}

TEST_CASE("a moving circle leaves no gap between steps") {
  auto p = stroke(Brush::circle, {3.2, 40.1, 0}, {57.6, 5.4, 0}, 2.3F);
  p.at = 0;
  p.until = 1;
  for (const int rate : {4, 10, 37}) {
    const Strokes strokes({p}, 1);
    std::vector<char> seen(static_cast<std::size_t>(grid.x * grid.y));
    for (int step = 0; step < rate + 3; ++step)
      for (const shader::Stroke& s : strokes.during(static_cast<double>(step) / rate, 1.0 / rate, step))
        for (const glm::ivec2 c : painted(strokes, s))
          seen[static_cast<std::size_t>(c.y * grid.x + c.x)] = 1;
    for (int y = 0; y < grid.y; ++y)
      for (int x = 0; x < grid.x; ++x) {
        const double d = distance({x, y}, {3.2, 40.1}, {57.6, 5.4});
        if (std::abs(d - 2.3) > 1e-3)
          CHECK((seen[static_cast<std::size_t>(y * grid.x + x)] != 0) == (d < 2.3));
      }
  }
}

TEST_CASE("a sparse stroke paints its share, others in each step and for each seed") {
  auto p = stroke(Brush::circle, {30, 23, 0}, {30, 23, 0}, 100);
  const std::size_t all = paintedAtOnce(p).size();
  CHECK(all == static_cast<std::size_t>(grid.x * grid.y));
  p.share = 0;
  CHECK(paintedAtOnce(p).empty());
  p.share = 0.25F;
  p.until = 1;
  const auto shareOf = [&](int seed, long step) {
    const Strokes strokes({p}, seed);
    return painted(strokes, strokes.during(0.1 * static_cast<double>(step), 0.1, step)[0]);
  };
  const auto first = shareOf(1, 0);
  CHECK(static_cast<double>(first.size()) / static_cast<double>(all) == doctest::Approx(0.25).epsilon(0.1));
  CHECK(first == shareOf(1, 0));
  CHECK(first != shareOf(1, 1));
  CHECK(first != shareOf(2, 0));
}

TEST_CASE("an image stamps its light pixels at its place") {
  auto p = stroke(Brush::image, {-3, 5, 0}, {-3, 5, 0}, 2);
  p.image = sourceFolder() + "/assets/textures/gingham.png";
  const auto here = paintedAtOnce(p);
  CHECK_FALSE(here.empty());
  CHECK(here.size() < static_cast<std::size_t>(grid.x * grid.y));
  p.from.x = -2;
  const auto shifted = paintedAtOnce(p);
  std::size_t both = 0;
  for (const glm::ivec2 c : here)
    for (const glm::ivec2 d : shifted) both += d == c + glm::ivec2(1, 0) ? 1 : 0;
  std::size_t expected = 0;
  for (const glm::ivec2 c : here) expected += c.x + 1 < grid.x ? 1 : 0;
  CHECK(both == expected);
  p.image = "/nowhere/none.png";
  CHECK_THROWS_AS(Strokes({p}, 1), UserError);
}
