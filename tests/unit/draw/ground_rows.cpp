// Rows of the picture that may see the ground.
#include "draw/exact/exact_view.hpp"

#include <random>

#include <doctest/doctest.h>

namespace {

using simreel::draw::rowsTowardsGround;
using simreel::shader::ExactView;

/// A camera at `height` (m) that looks up by `pitch` and is turned by `roll` (tangents).
ExactView viewOf(float height, float pitch, float roll, glm::ivec2 size) {
  ExactView view{};
  view.eye = {0, height, 0, 0};
  view.rayAcross = {1.0F / static_cast<float>(size.x), roll / static_cast<float>(size.x), 0, 0};
  view.rayDown = {0, -1.0F / static_cast<float>(size.y), 0, 0};
  view.ray = {-0.5F, pitch + 0.5F, -1, 0};
  view.size = size;
  view.rows = {0, size.y};
  return view;
}

bool sees(const ExactView& view, float ground, int row) {
  for (int x = 0; x <= view.size.x; ++x)
    for (const int y : {row, row + 1}) {
      const float up =
          view.ray.y + view.rayAcross.y * static_cast<float>(x) + view.rayDown.y * static_cast<float>(y);
      if (view.eye.y > ground ? up < -1e-6F : up > 1e-6F) return true;
    }
  return false;
}

}  // namespace

TEST_CASE("ground: every row that sees it is among those that may, and few others are") {
  constexpr int step = 8;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(-1, 1);
  for (int i = 0; i < 200; ++i) {
    ExactView view = viewOf(3 * any(random), any(random), 0.6F * any(random), {91, 67});
    if (i % 3 == 0) view.rows = {16, 51};
    const float ground = any(random);
    const glm::ivec2 rows = rowsTowardsGround(view, ground, step);
    int first = -1;
    int last = -1;
    for (int row = view.rows.x; row < view.rows.y; ++row) {
      if (!sees(view, ground, row)) continue;
      if (first < 0) first = row - view.rows.x;
      last = row - view.rows.x;
    }
    CAPTURE(i);
    if (first < 0) {
      CHECK(rows.y - rows.x <= step);
      continue;
    }
    CHECK(rows.x <= first);
    CHECK(rows.y > last);
    CHECK(rows.x > first - 2 * step);
    CHECK(rows.y <= last + 2 * step + 1);
    CHECK(rows.x % step == 0);
    CHECK(rows.y % step == 0);
  }
}
