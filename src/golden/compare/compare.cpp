#include "golden/compare/compare.hpp"

#include "base/error.hpp"
#include "golden/compare/bands.hpp"
#include "golden/compare/flip.hpp"
#include "golden/compare/ssim.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>

#include <fmt/format.h>

namespace simreel::golden {

namespace {

struct RowDifference {
  int worst = 0, worstX = 0;
  int different = 0, beyond = 0;
  bool colour = false;  ///< R, G or B differ, not only alpha
};

int channelDifference(const std::uint8_t* a, const std::uint8_t* b) {
  int apart = 0;
  for (int c = 0; c < 4; ++c) apart = std::max(apart, std::abs(int{a[c]} - int{b[c]}));
  return apart;
}

/// `beyond` gets 1 for each pixel that is further apart than the tolerance's maxChannelDiff.
RowDifference compareRow(const std::uint8_t* a, const std::uint8_t* b, int width, int channel,
                         std::uint8_t* beyond) {
  RowDifference row;
  if (std::memcmp(a, b, std::size_t(width) * 4) == 0) return row;
  for (int x = 0; x < width; ++x, a += 4, b += 4) {
    const int apart = channelDifference(a, b);
    if (apart == 0) continue;
    ++row.different;
    row.colour = row.colour || std::memcmp(a, b, 3) != 0;
    if (apart > row.worst) {
      row.worst = apart;
      row.worstX = x;
    }
    if (apart > channel) {
      ++row.beyond;
      beyond[x] = 1;
    }
  }
  return row;
}

/// Finds the N x N window with most marked pixels, from a summed-area table.
void densestWindow(const std::vector<std::uint8_t>& beyond, int width, int height, int size,
                   Metrics& metrics) {
  const std::size_t stride = std::size_t(width) + 1;
  // sums[y][x] counts the marks above row y and left of column x.
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

}  // namespace

Metrics measure(const frame::Image& a, const frame::Image& b, const scene::Tolerance& tolerance) {
  SIMREEL_CHECK_EQ(a.width, b.width);
  SIMREEL_CHECK_EQ(a.height, b.height);
  SIMREEL_CHECK(a.width > 0 && a.height > 0 && tolerance.windowSize > 0);
  Metrics metrics;
  metrics.psnr = std::numeric_limits<double>::infinity();
  if (a.bytes == b.bytes) return metrics;

  const std::size_t width = std::size_t(a.width);
  std::vector<RowDifference> rows(std::size_t(a.height));
  std::vector<std::uint8_t> beyond(width * std::size_t(a.height), 0);
  forEachBand(a.height, [&](int first, int last) {
    for (std::size_t y = std::size_t(first); y < std::size_t(last); ++y)
      rows[y] = compareRow(a.bytes.data() + y * width * 4, b.bytes.data() + y * width * 4, a.width,
                           tolerance.maxChannelDiff, beyond.data() + y * width);
  });
  bool colour = false;
  for (std::size_t y = 0; y < rows.size(); ++y) {
    metrics.differentPixels += rows[y].different;
    metrics.pixelsBeyond += rows[y].beyond;
    colour = colour || rows[y].colour;
    if (rows[y].worst <= metrics.worst) continue;
    metrics.worst = rows[y].worst;
    metrics.worstX = rows[y].worstX;
    metrics.worstY = static_cast<int>(y);
  }
  metrics.ratioBeyond = double(metrics.pixelsBeyond) / (double(a.width) * a.height);
  if (metrics.pixelsBeyond > 0) densestWindow(beyond, a.width, a.height, tolerance.windowSize, metrics);
  if (!colour) return metrics;
  metrics.psnr = psnr(a, b);
  metrics.ssim = ssim(a, b);
  metrics.flipMean = flipMean(a, b);
  return metrics;
}

double allowedRatio(const scene::Tolerance& tolerance) {
  if (tolerance.maxDiffRatio) return *tolerance.maxDiffRatio;
  return tolerance.maxDiffPixels ? 1.0 : 0.02;
}

std::vector<std::string> brokenBounds(const Metrics& metrics, const scene::Tolerance& tolerance, int width,
                                      int height) {
  std::vector<std::string> broken;
  const int channel = tolerance.maxChannelDiff;
  const std::string apart = channel == 0 ? "" : fmt::format(" by more than {}", channel);
  if (tolerance.hardFail && metrics.worst > *tolerance.hardFail)
    broken.push_back(fmt::format("the pixel at x {}, y {} differs by {} (hardFail is {})", metrics.worstX,
                                 metrics.worstY, metrics.worst, *tolerance.hardFail));
  if (tolerance.maxDiffPixels && double(metrics.pixelsBeyond) > *tolerance.maxDiffPixels)
    broken.push_back(fmt::format("{} pixel{}{} (maxDiffPixels is {})", metrics.pixelsBeyond,
                                 metrics.pixelsBeyond == 1 ? " differs" : "s differ", apart,
                                 *tolerance.maxDiffPixels));
  if (metrics.ratioBeyond > allowedRatio(tolerance))
    broken.push_back(fmt::format("{} of the pixels differ{} (maxDiffRatio is {})",
                                 percent(metrics.ratioBeyond), apart, allowedRatio(tolerance)));
  if (tolerance.maxWindowRatio && metrics.windowRatio > *tolerance.maxWindowRatio)
    broken.push_back(fmt::format("{} of the {}x{} window at x {}, y {} differ{} (maxWindowRatio is {})",
                                 percent(metrics.windowRatio), std::min(tolerance.windowSize, width),
                                 std::min(tolerance.windowSize, height), metrics.windowX, metrics.windowY,
                                 apart, *tolerance.maxWindowRatio));
  if (tolerance.maxFlipMean && metrics.flipMean > *tolerance.maxFlipMean)
    broken.push_back(fmt::format("the mean FLIP error is {:.4g} (maxFlipMean is {})", metrics.flipMean,
                                 *tolerance.maxFlipMean));
  return broken;
}

std::vector<std::string> brokenNearness(const Metrics& metrics, int width, int height) {
  std::vector<std::string> broken;
  const double ratio = double(metrics.differentPixels) / (double(width) * height);
  if (metrics.worst > nearChannel)
    broken.push_back(fmt::format("the pixel at x {}, y {} differs by {} (on another machine by {} at most)",
                                 metrics.worstX, metrics.worstY, metrics.worst, nearChannel));
  if (ratio > nearRatio)
    broken.push_back(fmt::format("{} of the pixels differ (on another machine {} at most)", percent(ratio),
                                 percent(nearRatio)));
  if (metrics.flipMean > nearFlipMean)
    broken.push_back(fmt::format("the mean FLIP error is {:.4g} (on another machine {} at most)",
                                 metrics.flipMean, nearFlipMean));
  return broken;
}

}  // namespace simreel::golden
