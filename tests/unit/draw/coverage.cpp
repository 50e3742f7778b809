// Tests the coverage of pixels by polygons.
#include "draw/overlay/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

using Polygon = std::vector<glm::dvec2>;

double areaOf(const draw::Coverage& coverage) {
  return std::accumulate(coverage.share.begin(), coverage.share.end(), 0.0) / 255;
}

Polygon circle(glm::dvec2 middle, double radius, int corners, double turn = 1) {
  Polygon points;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn * 2 * std::numbers::pi * i / corners;
    points.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

}  // namespace

TEST_CASE("coverage: each pixel's coverage is the fraction of its area inside the rectangle") {
  const std::vector<Polygon> box = {{{1.25, 2.5}, {4.5, 2.5}, {4.5, 4.75}, {1.25, 4.75}}};
  const draw::Coverage found = draw::coverageOf(box, {20, 10});
  CHECK(found.corner == glm::ivec2(1, 2));
  REQUIRE(found.size == glm::ivec2(4, 3));
  const double across[] = {0.75, 1, 1, 0.5}, down[] = {0.5, 1, 0.75};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      CHECK(int{found.share[static_cast<std::size_t>(4 * y + x)]} ==
            static_cast<int>(std::floor(255 * across[x] * down[y] + 0.5)));
}

TEST_CASE("coverage: pixels on a triangle's slope have their exact area, in either winding order") {
  // The triangle is below the line y = x / 2. The row has the pixels (x, 0) for x = 0 to 3.
  for (const bool back : {false, true}) {
    std::vector<Polygon> triangle = {{{0, 0}, {4, 0}, {4, 2}}};
    if (back) std::reverse(triangle[0].begin(), triangle[0].end());
    const draw::Coverage found = draw::coverageOf(triangle, {4, 2});
    REQUIRE(found.size == glm::ivec2(4, 2));
    const double wanted[] = {0.25, 0.75, 1, 1, 0, 0, 0.25, 0.75};
    for (std::size_t i = 0; i < 8; ++i)
      CHECK(int{found.share[i]} == static_cast<int>(std::floor(255 * wanted[i] + 0.5)));
  }
}

TEST_CASE("coverage: rings have holes and the area of their circles") {
  const glm::dvec2 middle(40.3, 31.7);
  const std::vector<Polygon> ring = {circle(middle, 25, 400), circle(middle, 14, 400, -1)};
  const draw::Coverage found = draw::coverageOf(ring, {91, 67});
  CHECK(areaOf(found) == doctest::Approx(std::numbers::pi * (625 - 196)).epsilon(1e-3));
  const glm::ivec2 at = glm::ivec2(middle) - found.corner;
  CHECK(found.share[static_cast<std::size_t>(at.y * found.size.x + at.x)] == 0);
}

TEST_CASE("coverage: shapes are clipped at the picture, and shapes outside have no coverage") {
  const std::vector<Polygon> disc = {circle({0, 33}, 20, 400)};
  CHECK(areaOf(draw::coverageOf(disc, {91, 67})) == doctest::Approx(std::numbers::pi * 200).epsilon(2e-3));
  const std::vector<Polygon> corner = {circle({91, 67}, 20, 400)};
  CHECK(areaOf(draw::coverageOf(corner, {91, 67})) ==
        doctest::Approx(std::numbers::pi * 100).epsilon(3e-3));
  CHECK(draw::coverageOf(std::vector<Polygon>{circle({-30, 33}, 20, 40)}, {91, 67}).share.empty());
  CHECK(draw::coverageOf({}, {91, 67}).share.empty());
}
