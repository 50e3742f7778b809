// Tests the range of picture rows in which the ground may be visible.
#include "draw/exact/exact_view.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <doctest/doctest.h>

namespace {

using simreel::draw::rowsTowardsGround;
using simreel::shader::ExactView;

/// Returns a camera at `height` (m), pitched up by `pitch` and rolled by `roll` (tangents of the angles).
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

TEST_CASE("ground: the row range contains every row that sees the ground and few others") {
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

TEST_CASE(
    "ground: within a pixel, nearness and rays deviate from the pixel's centre by at most a tight bound") {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> any(-1, 1);
  const glm::ivec2 size(91, 67);
  for (int i = 0; i < 100; ++i) {
    ExactView view = viewOf(3 * any(random), any(random), 0.6F * any(random), size);
    view.near = 0.05F;
    view.rayDown.z = 0.3F * any(random) / static_cast<float>(size.y);
    const float ground = any(random);
    const glm::vec4 near = simreel::draw::groundNearnessOf(view, ground);
    const glm::vec3 rays = simreel::draw::rayBounds(view);
    const double down = static_cast<double>(ground) - view.eye.y;
    CAPTURE(i);
    double farthest = 0;
    double off = 0;
    double offX = 0;
    double offZ = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        for (const int corner : {0, 1, 2, 3}) {
          const double right = x + (corner & 1), below = y + (corner >> 1);
          const auto ray = [&](int axis) {
            return view.ray[axis] + view.rayAcross[axis] * right + view.rayDown[axis] * below;
          };
          const auto middle = [&](int axis) {
            return view.ray[axis] + view.rayAcross[axis] * (x + 0.5) + view.rayDown[axis] * (y + 0.5);
          };
          const double there = view.near * ray(1) / down;
          const double about = near.x + static_cast<double>(near.y) * x + static_cast<double>(near.z) * y;
          off = std::max(off, std::abs(there - about));
          farthest = std::max({farthest, view.near * std::abs(ray(0)), view.near * std::abs(ray(2))});
          offX = std::max(offX, view.near * std::abs(ray(0) - middle(0)));
          offZ = std::max(offZ, view.near * std::abs(ray(2) - middle(2)));
        }
    CHECK_LE(off, near.w);
    CHECK_GT(off, 0.9 * near.w);
    CHECK_LE(offX, rays.y);
    CHECK_LE(offZ, rays.z);
    CHECK_LE(farthest, rays.x);
  }
}
