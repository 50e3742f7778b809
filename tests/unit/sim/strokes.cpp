#include "sim/grid/strokes.hpp"

#include "base/error.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::sim;

namespace {

using StrokeShape = StrokeParameters::Shape;

StrokeParameters stroke(StrokeShape shape, glm::vec3 from, glm::vec3 to, float radius) {
  StrokeParameters p;
  p.shape = shape;
  p.from = from;
  p.to = to;
  p.radius = radius;
  return p;
}

constexpr glm::ivec2 strokeGrid(61, 47);
const StrokeGrid bounded{strokeGrid, false, "field \"f\""};

/// Returns the painted cells of the first step. Checks that all are inside the stroke's box.
std::vector<glm::ivec2> painted(const Strokes& strokes, const shader::Stroke& s) {
  const glm::ivec4 box = Strokes::box(s, strokeGrid);
  CHECK(box.x >= 0);
  CHECK(box.y >= 0);
  CHECK(box.x + box.z <= strokeGrid.x);
  CHECK(box.y + box.w <= strokeGrid.y);
  std::vector<glm::ivec2> cells;
  for (int y = 0; y < strokeGrid.y; ++y)
    for (int x = 0; x < strokeGrid.x; ++x) {
      if (!strokes.paints(s, {x, y})) continue;
      cells.emplace_back(x, y);
      const bool inside = x >= box.x && x < box.x + box.z && y >= box.y && y < box.y + box.w;
      CHECK_MESSAGE(inside, x, " ", y);
    }
  return cells;
}

std::vector<glm::ivec2> paintedAtOnce(const StrokeParameters& p) {
  const Strokes strokes({p}, 1, bounded);
  const auto active = strokes.into(0, 0.1, 0);
  REQUIRE(active.size() == 1);
  return painted(strokes, active[0]);
}

/// Returns the distance from a cell's centre to a segment, in double precision.
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

TEST_CASE("a circle and a line paint the cells whose centre is within the radius") {
  struct {
    StrokeShape shape;
    glm::dvec2 from, to;
    double radius;
  } const cases[] = {{StrokeShape::circle, {30.3, 20.1}, {30.3, 20.1}, 7.2},
                     {StrokeShape::line, {5.7, 40.2}, {55.1, 3.9}, 3.3},
                     {StrokeShape::line, {-20, 10}, {90, 10}, 0.7},
                     {StrokeShape::circle, {0, 0}, {0, 0}, 11.9},
                     {StrokeShape::line, {12.4, 13.6}, {12.4, 13.6}, 2.6},
                     {StrokeShape::circle, {500, 500}, {500, 500}, 30}};
  for (const auto& c : cases) {
    const auto cells = paintedAtOnce(
        stroke(c.shape, glm::vec3(c.from, 0), glm::vec3(c.to, 0), static_cast<float>(c.radius)));
    std::vector<glm::ivec2> expected;
    for (int y = 0; y < strokeGrid.y; ++y)
      for (int x = 0; x < strokeGrid.x; ++x)
        if (distance({x, y}, c.from, c.to) <= c.radius) expected.emplace_back(x, y);
    CHECK(cells == expected);
  }
}

// The expected cells are those within the radius of a segment on the unrolled torus. Every image of every
// cell is tested in double precision.
TEST_CASE("a stroke on a torus continues at the opposite border") {
  struct {
    glm::ivec2 size;
    StrokeShape shape;
    glm::dvec2 from, to;
    double radius;
  } const cases[] = {{{61, 47}, StrokeShape::circle, {0.3, 46.2}, {0.3, 46.2}, 5.2},
                     {{61, 47}, StrokeShape::circle, {30.1, 20.2}, {30.1, 20.2}, 7.7},
                     {{61, 47}, StrokeShape::circle, {-300.4, 512.9}, {-300.4, 512.9}, 11.3},
                     {{61, 47}, StrokeShape::line, {55.1, 40.2}, {70.3, 60.9}, 3.1},
                     {{61, 47}, StrokeShape::line, {-100.7, -90.1}, {150.2, 10.4}, 1.3},
                     {{61, 47}, StrokeShape::circle, {10.2, 5.1}, {10.2, 5.1}, 29.7},
                     {{61, 47}, StrokeShape::circle, {10.2, 5.1}, {10.2, 5.1}, 400},
                     {{5, 64}, StrokeShape::circle, {2.2, 63.1}, {2.2, 63.1}, 20.4},
                     {{5, 64}, StrokeShape::line, {4.1, 1.2}, {17.3, 30.8}, 0.9},
                     {{1, 33}, StrokeShape::circle, {0.5, 0.6}, {0.5, 0.6}, 7.2},
                     {{33, 1}, StrokeShape::line, {30.2, 0.3}, {39.7, 2.8}, 2.3},
                     {{3, 3}, StrokeShape::circle, {0.1, 2.9}, {0.1, 2.9}, 1.2}};
  for (const auto& c : cases) {
    CAPTURE(c.size.x);
    CAPTURE(c.from.x);
    CAPTURE(c.radius);
    const auto p = stroke(c.shape, glm::vec3(c.from, 0), glm::vec3(c.to, 0), static_cast<float>(c.radius));
    const Strokes strokes({p}, 1, {c.size, true, "field"});
    const auto images = strokes.into(0, 0.1, 0);
    CHECK(images.size() <= 60);
    // number of images along each axis, enough to include the nearest one
    const glm::ivec2 around(2 + static_cast<int>((600 + c.radius) / c.size.x),
                            2 + static_cast<int>((600 + c.radius) / c.size.y));
    for (int y = 0; y < c.size.y; ++y)
      for (int x = 0; x < c.size.x; ++x) {
        double nearest = 1e9;
        for (int j = -around.y; j <= around.y; ++j)
          for (int i = -around.x; i <= around.x; ++i)
            nearest = std::min(nearest, distance({x + i * c.size.x, y + j * c.size.y}, c.from, c.to));
        if (std::abs(nearest - c.radius) < 1e-3) continue;
        bool painted = false;
        for (const shader::Stroke& s : images) {
          const glm::ivec4 box = Strokes::box(s, c.size);
          const bool inside = x >= box.x && x < box.x + box.z && y >= box.y && y < box.y + box.w;
          painted = painted || (inside && strokes.paints(s, {x, y}));
        }
        CHECK(painted == (nearest < c.radius));
      }
  }
}

TEST_CASE("a stamp on a torus continues at the opposite border, also if it is larger than the torus") {
  std::string text = "P5 9 7 255\n";
  for (int i = 0; i < 63; ++i) text += i * 5 % 7 < 3 || i == 62 ? '\xff' : '\0';
  const simreel::test::TemporaryFile file("stamp.pgm", text);
  for (const glm::ivec2 size : {glm::ivec2(20, 11), glm::ivec2(9, 7), glm::ivec2(4, 3)})
    for (const glm::ivec2 at : {glm::ivec2(-5, 3), glm::ivec2(17, 9), glm::ivec2(1000, -999)}) {
      auto p = stroke(StrokeShape::image, {at.x, at.y, 0}, {at.x, at.y, 0}, 0);
      p.image = file.path();
      const Strokes strokes({p}, 1, {size, true, "field"});
      std::vector<char> expected(static_cast<std::size_t>(size.x * size.y));
      const auto wrapped = [](int x, int side) { return (x % side + side) % side; };
      for (int i = 0; i < 63; ++i)
        if (i * 5 % 7 < 3 || i == 62)
          expected[static_cast<std::size_t>(wrapped(at.y + i / 9, size.y) * size.x +
                                            wrapped(at.x + i % 9, size.x))] = 1;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          bool painted = false;
          for (const shader::Stroke& s : strokes.into(0, 0.1, 0))
            painted = painted || strokes.paints(s, {x, y});
          CHECK(painted == (expected[static_cast<std::size_t>(y * size.x + x)] != 0));
        }
    }
}

TEST_CASE("a stroke that wraps around a torus too often is refused in one line") {
  auto p = stroke(StrokeShape::line, {0, 0, 0}, {1e6, 0, 0}, 1);
  try {
    const Strokes strokes({p}, 1, {{64, 64}, true, "field \"f\""});
    FAIL("accepted");
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    CHECK(std::string(error.what()).find("field \"f\": strokes[0] wraps around the torus") == 0);
  }
  p.to.x = 900 * 64;
  CHECK_FALSE(Strokes({p}, 1, {{64, 64}, true, "field"}).into(0, 1, 0).empty());
}

TEST_CASE("a stroke of zero duration paints into exactly one state, the first at or after it") {
  for (const double rate : {10.0, 7.0, 60.0, 29.97})
    for (const double at : {0.0, 0.1, 0.25, 0.7, 1.0, -0.3, 2.999}) {
      auto p = stroke(StrokeShape::circle, {5, 5, 0}, {5, 5, 0}, 2);
      p.at = p.until = at;
      const Strokes strokes({p}, 1, bounded);
      int times = 0;
      long when = 0;
      for (long step = -100; step < 400; ++step)
        if (!strokes.into(static_cast<double>(step) / rate, 1 / rate, step).empty()) {
          ++times;
          when = step;
        }
      CHECK(times == 1);
      CHECK(when == static_cast<long>(std::ceil(at * rate - 1e-6)));
    }
}

TEST_CASE("a long stroke paints every state from its start to its end") {
  auto p = stroke(StrokeShape::line, {5, 5, 0}, {9, 5, 0}, 2);
  p.at = 0.35;
  p.until = 0.8;
  const Strokes strokes({p}, 1, bounded);
  for (int step = 0; step < 20; ++step)
    CHECK(strokes.into(step * 0.1, 0.1, step).size() == (step >= 4 && step <= 8 ? 1 : 0));
}

TEST_CASE("a moving circle leaves no gap between steps") {
  auto p = stroke(StrokeShape::circle, {3.2, 40.1, 0}, {57.6, 5.4, 0}, 2.3F);
  p.at = 0;
  p.until = 1;
  for (const int rate : {4, 10, 37}) {
    const Strokes strokes({p}, 1, bounded);
    std::vector<char> seen(static_cast<std::size_t>(strokeGrid.x * strokeGrid.y));
    for (int step = 0; step < rate + 3; ++step)
      for (const shader::Stroke& s : strokes.into(static_cast<double>(step) / rate, 1.0 / rate, step))
        for (const glm::ivec2 c : painted(strokes, s))
          seen[static_cast<std::size_t>(c.y * strokeGrid.x + c.x)] = 1;
    for (int y = 0; y < strokeGrid.y; ++y)
      for (int x = 0; x < strokeGrid.x; ++x) {
        const double d = distance({x, y}, {3.2, 40.1}, {57.6, 5.4});
        if (std::abs(d - 2.3) > 1e-3)
          CHECK((seen[static_cast<std::size_t>(y * strokeGrid.x + x)] != 0) == (d < 2.3));
      }
  }
}

TEST_CASE("a sparse stroke paints its fraction of cells, different for each step and seed") {
  auto p = stroke(StrokeShape::circle, {30, 23, 0}, {30, 23, 0}, 100);
  const std::size_t all = paintedAtOnce(p).size();
  CHECK(all == static_cast<std::size_t>(strokeGrid.x * strokeGrid.y));
  p.fraction = 0;
  CHECK(paintedAtOnce(p).empty());
  p.fraction = 0.25F;
  p.until = 1;
  const auto shareOf = [&](int seed, long step) {
    const Strokes strokes({p}, seed, bounded);
    return painted(strokes, strokes.into(0.1 * static_cast<double>(step), 0.1, step)[0]);
  };
  const auto first = shareOf(1, 0);
  CHECK(static_cast<double>(first.size()) / static_cast<double>(all) ==
        doctest::Approx(0.25).epsilon(0.1).scale(0));
  CHECK(first == shareOf(1, 0));
  CHECK(first != shareOf(1, 1));
  CHECK(first != shareOf(2, 0));
}

TEST_CASE("an image stroke stamps its light pixels at its position") {
  auto p = stroke(StrokeShape::image, {-3, 5, 0}, {-3, 5, 0}, 2);
  p.image = sourceFolder() + "/assets/textures/gingham.png";
  const auto here = paintedAtOnce(p);
  CHECK_FALSE(here.empty());
  CHECK(here.size() < static_cast<std::size_t>(strokeGrid.x * strokeGrid.y));
  p.from.x = -2;
  const auto shifted = paintedAtOnce(p);
  std::size_t both = 0;
  for (const glm::ivec2 c : here)
    for (const glm::ivec2 d : shifted) both += d == c + glm::ivec2(1, 0) ? 1 : 0;
  std::size_t expected = 0;
  for (const glm::ivec2 c : here) expected += c.x + 1 < strokeGrid.x ? 1 : 0;
  CHECK(both == expected);
  p.image = "/nowhere/none.png";
  CHECK_THROWS_AS(Strokes({p}, 1, bounded), UserError);
}

TEST_CASE("a stroke that begins with the run acts before its time, at the place of its start") {
  auto p = stroke(StrokeShape::circle, {10, 20, 0}, {30, 20, 0}, 3);
  p.until = 2;
  CHECK(Strokes({p}, 1, bounded).into(-1, 0.1, -10).empty());
  p.early = true;
  const Strokes strokes({p}, 1, bounded);
  const auto before = strokes.into(-1, 0.1, -10);
  REQUIRE(before.size() == 1);
  CHECK(before[0].from == glm::vec2(10, 20));
  CHECK(before[0].to == glm::vec2(10, 20));
  CHECK(strokes.into(1, 0.1, 10)[0].to == glm::vec2(20, 20));
  CHECK(strokes.into(3, 0.1, 30).empty());
}
