#include "golden/compare/compare.hpp"

#include "base/error.hpp"
#include "golden/compare/flip.hpp"
#include "golden/compare/ssim.hpp"
#include "golden/compare/tiles.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>

#include <fmt/format.h>

namespace simreel::golden {

namespace {

struct RowDifference {
  double worst = 0;
  int worstX = 0;
  int different = 0, beyond = 0;

  void add(int x, double difference, int channel, std::uint8_t* marks) {
    if (difference == 0) return;
    ++different;
    if (difference > worst) {
      worst = difference;
      worstX = x;
    }
    if (difference > channel) {
      ++beyond;
      marks[x] = 1;
    }
  }
};

int channelDifference(const std::uint8_t* a, const std::uint8_t* b) {
  int difference = 0;
  for (int c = 0; c < 4; ++c) difference = std::max(difference, std::abs(int{a[c]} - int{b[c]}));
  return difference;
}

/// Compares one row. Sets `beyond` to 1 for each pixel with a channel difference above `channel`.
RowDifference compareRow(const std::uint8_t* a, const std::uint8_t* b, int width, int channel,
                         std::uint8_t* beyond) {
  RowDifference row;
  if (std::memcmp(a, b, std::size_t(width) * 4) == 0) return row;
  for (int x = 0; x < width; ++x, a += 4, b += 4) row.add(x, channelDifference(a, b), channel, beyond);
  return row;
}

/// Finds the window of `size` x `size` pixels with the most marked pixels, using a summed-area table.
void densestWindow(const std::vector<std::uint8_t>& beyond, int width, int height, int size,
                   Metrics& metrics) {
  const std::size_t stride = std::size_t(width) + 1;
  // sums[y][x] is the number of marked pixels above row y and to the left of column x.
  std::vector<std::int32_t> sums(stride * (std::size_t(height) + 1), 0);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* marks = beyond.data() + std::size_t(y) * std::size_t(width);
    const std::int32_t* above = sums.data() + std::size_t(y) * stride;
    std::int32_t* below = sums.data() + std::size_t(y + 1) * stride;
    std::int32_t line = 0;
    for (int x = 0; x < width; ++x) {
      line += marks[x];
      below[x + 1] = above[x + 1] + line;
    }
  }
  const int w = std::min(size, width), h = std::min(size, height);
  std::int32_t max = 0;
  for (int y = 0; y + h <= height; ++y) {
    const std::int32_t* top = sums.data() + std::size_t(y) * stride;
    const std::int32_t* bottom = sums.data() + std::size_t(y + h) * stride;
    for (int x = 0; x + w <= width; ++x) {
      const std::int32_t count = bottom[x + w] - bottom[x] - top[x + w] + top[x];
      if (count <= max) continue;
      max = count;
      metrics.windowX = x;
      metrics.windowY = y;
    }
  }
  metrics.windowRatio = double(max) / (double(w) * h);
}

std::string percent(double ratio) {
  return fmt::format("{:.3g}%", ratio * 100);
}

/// True if some pixel is not opaque.
bool hasHoles(const frame::Image& image) {
  for (std::size_t i = 3; i < image.bytes.size(); i += 4)
    if (image.bytes[i] != 255) return true;
  return false;
}

frame::Image over(const frame::Image& image, int background) {
  frame::Image made = image;
  for (std::size_t i = 0; i < made.bytes.size(); i += 4) {
    const int alpha = made.bytes[i + 3];
    for (std::size_t c = i; c < i + 3; ++c)
      made.bytes[c] =
          static_cast<std::uint8_t>((made.bytes[c] * alpha + background * (255 - alpha) + 127) / 255);
    made.bytes[i + 3] = 255;
  }
  return made;
}

/// Measures PSNR, SSIM and FLIP. These metrics ignore alpha, so transparent pictures are measured over
/// black and over white.
void measureLook(const frame::Image& a, const frame::Image& b, Measures measures, Metrics& metrics) {
  if (hasHoles(a) || hasHoles(b)) {
    for (const int background : {0, 255})
      measureLook(over(a, background), over(b, background), measures, metrics);
    return;
  }
  if (a.bytes == b.bytes) return;
  metrics.psnr = std::min(metrics.psnr, psnr(a, b));
  if (measures == Measures::quick) return;
  metrics.ssim = std::min(metrics.ssim.value_or(1), ssim(a, b));
  metrics.flipMean = std::max(metrics.flipMean.value_or(0), flipMean(a, b));
}

/// Measures all rows. compareRow(y, marks) compares row y and marks the pixels beyond the tolerance.
template <class CompareRow>
Metrics measureRows(const frame::Image& a, const frame::Image& b, const scene::Tolerance& tolerance,
                    Measures measures, const CompareRow& compareRow) {
  const std::size_t width = std::size_t(a.width);
  Metrics metrics;
  metrics.psnr = std::numeric_limits<double>::infinity();
  if (measures == Measures::quick) metrics.ssim = metrics.flipMean = std::nullopt;
  std::vector<RowDifference> rows(std::size_t(a.height));
  std::vector<std::uint8_t> beyond(width * std::size_t(a.height), 0);
  forEachBand(a.height, [&](int first, int last) {
    for (std::size_t y = std::size_t(first); y < std::size_t(last); ++y)
      rows[y] = compareRow(y, beyond.data() + y * width);
  });
  for (std::size_t y = 0; y < rows.size(); ++y) {
    metrics.differentPixels += rows[y].different;
    metrics.pixelsBeyond += rows[y].beyond;
    if (rows[y].worst <= metrics.worst) continue;
    metrics.worst = rows[y].worst;
    metrics.worstX = rows[y].worstX;
    metrics.worstY = static_cast<int>(y);
  }
  metrics.ratioBeyond = double(metrics.pixelsBeyond) / (double(a.width) * a.height);
  if (metrics.pixelsBeyond > 0) densestWindow(beyond, a.width, a.height, tolerance.windowSize, metrics);
  measureLook(a, b, measures, metrics);
  return metrics;
}

}  // namespace

Metrics measure(const frame::Image& a, const frame::Image& b, const scene::Tolerance& tolerance,
                Measures measures) {
  SIMREEL_CHECK_EQ(a.width, b.width);
  SIMREEL_CHECK_EQ(a.height, b.height);
  SIMREEL_CHECK(a.width > 0 && a.height > 0 && tolerance.windowSize > 0);
  if (a.bytes == b.bytes) {
    Metrics metrics;
    metrics.psnr = std::numeric_limits<double>::infinity();
    return metrics;
  }
  const std::size_t stride = std::size_t(a.width) * 4;
  return measureRows(a, b, tolerance, measures, [&](std::size_t y, std::uint8_t* marks) {
    return compareRow(a.bytes.data() + y * stride, b.bytes.data() + y * stride, a.width,
                      tolerance.maxChannelDiff, marks);
  });
}

Metrics measureDifferences(const std::vector<float>& difference, const frame::Image& a,
                           const frame::Image& b, const scene::Tolerance& tolerance, Measures measures) {
  SIMREEL_CHECK_EQ(a.bytes.size(), 4 * difference.size());
  SIMREEL_CHECK_EQ(b.bytes.size(), 4 * difference.size());
  return measureRows(a, b, tolerance, measures, [&](std::size_t y, std::uint8_t* marks) {
    RowDifference row;
    for (int x = 0; x < a.width; ++x)
      row.add(x, difference[y * std::size_t(a.width) + std::size_t(x)], tolerance.maxChannelDiff, marks);
    return row;
  });
}

double allowedRatio(const scene::Tolerance& tolerance) {
  if (tolerance.maxDiffRatio) return *tolerance.maxDiffRatio;
  return tolerance.maxDiffPixels ? 1.0 : 0.02;
}

std::vector<std::string> brokenBounds(const Metrics& metrics, const scene::Tolerance& tolerance, int width,
                                      int height) {
  std::vector<std::string> broken;
  const int channel = tolerance.maxChannelDiff;
  const std::string difference = channel == 0 ? "" : fmt::format(" by more than {}", channel);
  if (tolerance.hardFail && metrics.worst > *tolerance.hardFail)
    broken.push_back(fmt::format("the pixel at x {}, y {} differs by {:.4g} (hardFail is {})",
                                 metrics.worstX, metrics.worstY, metrics.worst, *tolerance.hardFail));
  if (tolerance.maxDiffPixels && double(metrics.pixelsBeyond) > *tolerance.maxDiffPixels)
    broken.push_back(fmt::format("{} pixel{}{} (maxDiffPixels is {})", metrics.pixelsBeyond,
                                 metrics.pixelsBeyond == 1 ? " differs" : "s differ", difference,
                                 *tolerance.maxDiffPixels));
  if (metrics.ratioBeyond > allowedRatio(tolerance))
    broken.push_back(fmt::format("{} of the pixels differ{} (maxDiffRatio is {})",
                                 percent(metrics.ratioBeyond), difference, allowedRatio(tolerance)));
  if (tolerance.maxWindowRatio && metrics.windowRatio > *tolerance.maxWindowRatio)
    broken.push_back(fmt::format("{} of the {}x{} window at x {}, y {} differ{} (maxWindowRatio is {})",
                                 percent(metrics.windowRatio), std::min(tolerance.windowSize, width),
                                 std::min(tolerance.windowSize, height), metrics.windowX, metrics.windowY,
                                 difference, *tolerance.maxWindowRatio));
  if (const double flip = metrics.flipMean.value_or(0);
      tolerance.maxFlipMean && flip > *tolerance.maxFlipMean)
    broken.push_back(
        fmt::format("the mean FLIP error is {:.4g} (maxFlipMean is {})", flip, *tolerance.maxFlipMean));
  return broken;
}

std::vector<std::string> brokenNearness(const Metrics& metrics, int width, int height) {
  std::vector<std::string> broken;
  const double ratio = double(metrics.differentPixels) / (double(width) * height);
  if (metrics.worst > nearChannel)
    broken.push_back(
        fmt::format("the pixel at x {}, y {} differs by {:.4g} (on another machine by {} at most)",
                    metrics.worstX, metrics.worstY, metrics.worst, nearChannel));
  if (ratio > nearRatio)
    broken.push_back(fmt::format("{} of the pixels differ (on another machine {} at most)", percent(ratio),
                                 percent(nearRatio)));
  if (const double flip = metrics.flipMean.value_or(0); flip > nearFlipMean)
    broken.push_back(
        fmt::format("the mean FLIP error is {:.4g} (on another machine {} at most)", flip, nearFlipMean));
  return broken;
}

}  // namespace simreel::golden
