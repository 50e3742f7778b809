// Tests that the points at which a pixel's light is sampled (glsl/draw/exact/rays/sequence.glsl) stay
// evenly distributed after any scrambling.
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

#define FUNCTION inline
#define precise
namespace simreel::shader {
#include "glsl/draw/exact/rays/sequence.glsl"
}
#undef precise
#undef FUNCTION

using namespace simreel::shader;  // NOLINT: the model is written in GLSL's names

namespace {

/// Divides the unit square into as many cells as there are points. Returns the max number of points per
/// cell.
int fullest(const std::vector<vec3>& points, int first, int second, int columns) {
  const int rows = static_cast<int>(points.size()) / columns;
  std::vector<int> counts(points.size());
  for (const vec3& p : points) {
    const int x = static_cast<int>(p[first] * static_cast<float>(columns));
    const int y = static_cast<int>(p[second] * static_cast<float>(rows));
    ++counts[static_cast<std::size_t>(y * columns + x)];
  }
  return *std::max_element(counts.begin(), counts.end());
}

}  // namespace

TEST_CASE("rays: samples are distributed as evenly as Sobol points") {
  for (const uint seed : {1U, 77U, 0xdeadbeefU})
    for (const uint which : {0U, 3U})
      for (const uint count : {16U, 64U, 1024U}) {
        CAPTURE(seed);
        CAPTURE(which);
        CAPTURE(count);
        std::vector<vec3> points;
        for (uint i = 0; i < count; ++i) points.push_back(samplePoint(i, count - 1, seed, which));
        const int all = static_cast<int>(count);
        for (int axis = 0; axis < 3; ++axis) CHECK(fullest(points, axis, (axis + 1) % 3, all) == 1);
        for (int columns = 1; columns <= all; columns *= 2) {
          CHECK(fullest(points, 0, 1, columns) == 1);
          CHECK(fullest(points, 0, 2, columns) <= 2);
          CHECK(fullest(points, 1, 2, columns) <= 2);
        }
      }
}

TEST_CASE("rays: different pixels and sets have different points") {
  std::vector<float> first;
  for (uint seed = 0; seed < 1000; ++seed) first.push_back(samplePoint(0, 63, seed, 1).x);
  std::sort(first.begin(), first.end());
  CHECK(std::unique(first.begin(), first.end()) == first.end());
  for (int tenth = 0; tenth < 10; ++tenth) {
    const float low = 0.1F * static_cast<float>(tenth);
    const auto within =
        std::count_if(first.begin(), first.end(), [&](float x) { return x >= low && x < low + 0.1F; });
    CHECK(within > 60);
    CHECK(within < 140);
  }
  CHECK(samplePoint(5, 63, 9, 0) != samplePoint(5, 63, 9, 1));
}
