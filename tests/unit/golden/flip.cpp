// Tests FLIP and SSIM by comparison with values calculated by hand. tests/cli/golden/test_diff.py compares
// them with other programs.
#include "golden/compare/flip.hpp"

#include "golden/compare/ssim.hpp"
#include "unit/frame/help.hpp"

#include <array>
#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

frame::Image uniform(int width, int height, int r, int g, int b) {
  frame::Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    for (const int value : {r, g, b, 255}) image.bytes.push_back(static_cast<std::uint8_t>(value));
  return image;
}

/// Returns HyAB^0.7 of two Hunt-adjusted colours (L, a, b).
double powered(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::pow(std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), 0.7);
}

// Published CIELAB (D65) values of sRGB's green and blue, with a* and b* multiplied by 0.01 L*.
constexpr double greenL = 87.7347, blueL = 32.2970;
const std::array<double, 3> green = {greenL, -86.1827 * greenL / 100, 83.1793 * greenL / 100};
const std::array<double, 3> blue = {blueL, 79.1875 * blueL / 100, -107.8602 * blueL / 100};

}  // namespace

TEST_CASE("flip: green against blue is 1, equal pictures are 0") {
  const auto a = uniform(23, 17, 0, 255, 0), b = uniform(23, 17, 0, 0, 255);
  for (const float error : golden::flipMap(a, b)) CHECK(error == doctest::Approx(1).epsilon(1e-6));
  CHECK(golden::flipMean(a, a) == 0);
  CHECK(golden::flipMap(a, b).size() == 23 * 17);
}

TEST_CASE("flip: black against white and two greys equal values worked out by hand") {
  // Uniform pictures have no features, so only the colours contribute: a* = b* = 0, and HyAB is the
  // difference of L*.
  const double largest = powered(green, blue), knee = 0.4 * largest;
  const double blackWhite = std::pow(100, 0.7);
  const double expected = 0.95 + (blackWhite - knee) / (largest - knee) * 0.05;
  CHECK(golden::flipMean(uniform(9, 40, 0, 0, 0), uniform(9, 40, 255, 255, 255)) ==
        doctest::Approx(expected).epsilon(1e-5));
  // Returns L* of an sRGB byte, 116 y^(1/3) - 16 with the linear value y. It is used for 119 and 94.
  const auto lightness = [](double byte) {
    return 116 * std::cbrt(std::pow((byte / 255 + 0.055) / 1.055, 2.4)) - 16;
  };
  const double greys = 0.95 / knee * std::pow(lightness(119) - lightness(94), 0.7);
  CHECK(greys < 0.9);
  CHECK(golden::flipMean(uniform(50, 3, 119, 119, 119), uniform(50, 3, 94, 94, 94)) ==
        doctest::Approx(greys).epsilon(1e-4));
}

TEST_CASE("flip: the error is symmetric, and rows outside the filter's radius do not matter") {
  // Equal rows at the top of a tall picture must not change the error of a difference in its last rows.
  auto low = frame::test::picture(30, 60), changed = low;
  for (std::size_t i = 4 * 30 * 45; i < 4 * 30 * 47; ++i) changed.bytes[i] ^= 0x30;
  const auto map = golden::flipMap(low, changed), swapped = golden::flipMap(changed, low);
  CHECK(map == swapped);
  const auto above = frame::test::picture(30, 64, 9);
  const auto stack = [&](const frame::Image& below) {
    frame::Image all = above;
    all.height += below.height;
    all.bytes.insert(all.bytes.end(), below.bytes.begin(), below.bytes.end());
    return all;
  };
  const auto tall = golden::flipMap(stack(low), stack(changed));
  for (int y = 0; y < 124; ++y)
    for (int x = 0; x < 30; ++x) {
      const float error = tall[std::size_t(y * 30 + x)];
      if (y < 64 + 35 || y >= 64 + 57) CHECK(error == 0);
      if (y >= 64 + 20) CHECK(error == map[std::size_t((y - 64) * 30 + x)]);
    }
}

TEST_CASE("ssim: two greys equal a value worked out by hand, equal pictures are 1") {
  const auto a = uniform(20, 9, 50, 100, 200), b = uniform(20, 9, 60, 100, 180);
  // Without variance, the SSIM of each channel is (2 m n + C1) / (m^2 + n^2 + C1) with the means m and n
  // and C1 = (0.01 * 255)^2.
  const auto similarity = [](double m, double n) {
    return (2 * m * n + 6.5025) / (m * m + n * n + 6.5025);
  };
  CHECK(golden::ssim(a, b) ==
        doctest::Approx((similarity(50, 60) + 1 + similarity(200, 180)) / 3).epsilon(1e-4));
  CHECK(golden::ssim(a, a) == 1);
  CHECK(std::isinf(golden::psnr(a, a)));
  CHECK(golden::psnr(a, b) == doctest::Approx(10 * std::log10(255 * 255 / (500.0 / 3))));
}

TEST_CASE("ssim: a picture and its negative have an SSIM below 0.1") {
  const auto a = frame::test::picture(60, 60);
  auto b = a;
  for (std::size_t i = 0; i < b.bytes.size(); ++i)
    if (i % 4 != 3) b.bytes[i] = static_cast<std::uint8_t>(255 - b.bytes[i]);
  CHECK(golden::ssim(a, b) < 0.1);
  CHECK(golden::ssim(a, b) == golden::ssim(b, a));
}
