#include "golden/compare/compare.hpp"

#include "base/error.hpp"
#include "golden/compare/difference_image.hpp"
#include "unit/frame/help.hpp"

#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include <doctest/doctest.h>
#include <tbb/global_control.h>

using namespace simreel;

namespace {

frame::Image uniform(int width, int height, std::array<std::uint8_t, 4> pixel) {
  frame::Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    image.bytes.insert(image.bytes.end(), pixel.begin(), pixel.end());
  return image;
}

std::uint8_t& at(frame::Image& image, int x, int y, int channel) {
  return image.bytes[std::size_t((y * image.width + x) * 4 + channel)];
}

scene::Tolerance tolerance(int channel, std::optional<double> ratio = {}) {
  scene::Tolerance result;
  result.maxChannelDiff = channel;
  result.maxDiffRatio = ratio;
  return result;
}

}  // namespace

TEST_CASE("pictures are compared per channel, including alpha, and differences are counted per pixel") {
  const auto a = uniform(5, 3, {100, 100, 100, 100});
  auto b = a;
  at(b, 1, 0, 0) = 103;
  at(b, 1, 0, 2) = 97;  // This changes another channel of the same pixel, which still counts as one pixel.
  at(b, 2, 1, 1) = 80;
  at(b, 3, 1, 1) = 120;  // This is an equally large difference at a later pixel.
  at(b, 4, 2, 3) = 90;
  const auto metrics = golden::measure(a, b, tolerance(3));
  CHECK(metrics.worst == 20);
  CHECK(metrics.worstX == 2);
  CHECK(metrics.worstY == 1);
  CHECK(metrics.differentPixels == 4);
  CHECK(metrics.pixelsBeyond == 3);
  CHECK(metrics.ratioBeyond == doctest::Approx(3.0 / 15));
  CHECK(golden::measure(a, b, tolerance(2)).pixelsBeyond == 4);
  CHECK(golden::measure(a, b, tolerance(20)).pixelsBeyond == 0);
  // The squared differences are 9 + 9 + 400 + 400 over 45 values for opaque pixels. For transparent pixels,
  // the worse result of compositing over black and over white counts. Over black, round(100 / 255 of a
  // value) is 39 compared with 40, 38, 31 and 47 (and 35 for the alpha).
  auto solid = a, other = b;
  for (std::size_t i = 3; i < a.bytes.size(); i += 4) solid.bytes[i] = other.bytes[i] = 255;
  const auto psnrOf = [](double squares) {
    return doctest::Approx(10 * std::log10(255.0 * 255 / (squares / 45))).epsilon(1e-12);
  };
  CHECK(golden::measure(solid, other, tolerance(3)).psnr == psnrOf(818));
  const auto squaresOver = [&](int background) {
    double squares = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) {
      const auto over = [&](const frame::Image& image) {
        const int alpha = image.bytes[i | 3];
        return std::floor((image.bytes[i] * alpha + background * (255 - alpha)) / 255.0 + 0.5);
      };
      if (i % 4 != 3) squares += (over(a) - over(b)) * (over(a) - over(b));
    }
    return squares;
  };
  CHECK(squaresOver(0) != squaresOver(255));
  CHECK(metrics.psnr == psnrOf(std::max(squaresOver(0), squaresOver(255))));
}

TEST_CASE(
    "equal pictures have no perceptual difference; a difference in alpha alone is visible over a "
    "background") {
  const auto a = frame::test::picture(40, 30);
  auto b = a;
  const auto equal = golden::measure(a, b, tolerance(0));
  CHECK(equal.worst == 0);
  CHECK(std::isinf(equal.psnr));
  CHECK(equal.ssim == 1);
  CHECK(equal.flipMean == 0);
  at(b, 7, 8, 3) = 250;
  const auto seen = golden::measure(a, b, tolerance(0));
  CHECK(seen.worst == 5);
  CHECK(seen.differentPixels == 1);
  CHECK(seen.psnr > 60);
  CHECK(std::isfinite(seen.psnr));
  CHECK(seen.ssim < 1);
  CHECK(seen.flipMean > 0);
  // The colour of fully transparent pixels does not matter.
  auto c = a, d = a;
  for (auto* image : {&c, &d}) at(*image, 7, 8, 3) = 0;
  at(d, 7, 8, 0) = static_cast<std::uint8_t>(255 - at(c, 7, 8, 0));
  const auto unseen = golden::measure(c, d, tolerance(0));
  CHECK(unseen.differentPixels == 1);
  CHECK(std::isinf(unseen.psnr));
  CHECK(unseen.flipMean == 0);
}

TEST_CASE("the window with most differences is found anywhere and is clipped to small pictures") {
  const auto a = uniform(40, 30, {0, 0, 0, 255});
  auto b = a;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {39, 29}, {38, 29}, {37, 27}, {20, 10}})
    at(b, x, y, 1) = 50;
  scene::Tolerance t = tolerance(12);
  t.windowSize = 4;
  auto metrics = golden::measure(a, b, t);
  CHECK(metrics.windowRatio == 3.0 / 16);
  CHECK(metrics.windowX == 36);
  CHECK(metrics.windowY == 26);
  t.windowSize = 1;
  metrics = golden::measure(a, b, t);
  CHECK(metrics.windowRatio == 1);
  CHECK(metrics.windowX + metrics.windowY == 0);
  t.windowSize = 35;  // A window larger than the picture's height is clipped.
  metrics = golden::measure(a, b, t);
  CHECK(metrics.windowRatio == 4.0 / (35 * 30));
  CHECK(metrics.windowX == 5);
  t.windowSize = 1000;
  metrics = golden::measure(a, b, t);
  CHECK(metrics.windowRatio == 6.0 / (40 * 30));
  t.maxChannelDiff = 50;
  CHECK(golden::measure(a, b, t).windowRatio == 0);
}

TEST_CASE("all given bounds must hold; without bounds, 2% of pixels may differ") {
  const auto a = uniform(10, 10, {0, 0, 0, 255});
  auto b = a;
  at(b, 3, 4, 0) = 40;
  at(b, 5, 6, 0) = 13;
  const auto broken = [&](const scene::Tolerance& t) {
    return golden::brokenBounds(golden::measure(a, b, t), t, 10, 10);
  };
  using Clauses = std::vector<std::string>;
  scene::Tolerance t;
  CHECK(golden::allowedRatio(t) == 0.02);
  CHECK(broken(t) == Clauses());
  at(b, 0, 0, 0) = 13;
  CHECK(broken(t) == Clauses{"3% of the pixels differ by more than 12 (maxDiffRatio is 0.02)"});
  t.maxDiffPixels = 3;
  CHECK(golden::allowedRatio(t) == 1);
  CHECK(broken(t) == Clauses());
  t.maxDiffPixels = 2;
  CHECK(broken(t) == Clauses{"3 pixels differ by more than 12 (maxDiffPixels is 2)"});
  t.maxDiffRatio = 0.03;
  CHECK(broken(t).size() == 1);
  t.maxDiffRatio = 0.01;
  CHECK(broken(t).size() == 2);
  t.hardFail = 40;
  CHECK(broken(t).size() == 2);
  t.hardFail = 39;
  CHECK(broken(t)[0] == "the pixel at x 3, y 4 differs by 40 (hardFail is 39)");
  t = tolerance(255);  // None of the differences exceeds the tolerance, but hardFail always applies.
  t.hardFail = 39;
  CHECK(broken(t).size() == 1);
  t = tolerance(12, 1);
  t.windowSize = 5;
  t.maxWindowRatio = 0.08;
  CHECK(broken(t) == Clauses());
  t.maxWindowRatio = 0.079;
  CHECK(broken(t) ==
        Clauses{"8% of the 5x5 window at x 0, y 0 differ by more than 12 (maxWindowRatio is 0.079)"});
  t = tolerance(0, 1);
  t.maxFlipMean = golden::measure(a, b, t).flipMean;
  CHECK(*t.maxFlipMean > 0);
  CHECK(broken(t) == Clauses());
  t.maxFlipMean = *t.maxFlipMean * 0.99;
  CHECK(broken(t).size() == 1);
}

TEST_CASE("comparison results do not depend on the number of threads") {
  const auto a = frame::test::picture(150, 130), b = frame::test::picture(150, 130, 3);
  const auto several = golden::measure(a, b, {});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = golden::measure(a, b, {});
  CHECK(several.psnr == single.psnr);
  CHECK(several.ssim == single.ssim);
  CHECK(several.flipMean == single.flipMean);
}

TEST_CASE("a difference image shows all differing pixels and only those") {
  const auto a = frame::test::picture(256, 2);
  auto b = a;
  for (int x = 0; x < 256; ++x) {
    at(b, x, 0, 1) = static_cast<std::uint8_t>(at(b, x, 0, 1) < 128 ? 255 : 0);
    at(b, x, 1, x % 4) = static_cast<std::uint8_t>(at(b, x, 1, x % 4) ^ 1);
  }
  const auto spread = [](frame::Image& image, int x, int y) {
    const auto [r, g, blue] = std::tuple{at(image, x, y, 0), at(image, x, y, 1), at(image, x, y, 2)};
    return std::max({r, g, blue}) - std::min({r, g, blue});
  };
  auto heat = golden::differenceImage(a, b), same = golden::differenceImage(a, a);
  REQUIRE(heat.width == 256);
  REQUIRE(heat.bytes.size() == a.bytes.size());
  for (int x = 0; x < 256; ++x) {
    // A difference of 1/255 is bright blue, and half the range is red or orange. Equal pixels are dark
    // grey.
    CHECK(at(heat, x, 1, 2) > 200);
    CHECK(spread(heat, x, 1) > 100);
    CHECK(at(heat, x, 0, 0) > 200);
    CHECK(at(heat, x, 0, 2) < 100);
    CHECK(spread(same, x, 0) == 0);
    CHECK(at(same, x, 0, 0) < 80);
    CHECK(at(same, x, 0, 3) == 255);
  }
}
