#pragma once
#include "frame/image.hpp"
#include "golden/result.hpp"
#include "scene/test.hpp"

#include <string>
#include <vector>

namespace simreel::golden {

/// Set of measurements for differing pictures. `quick` omits the measurements that need filters (SSIM,
/// FLIP).
enum class Measures { all, quick };

/// Compares two pictures, which must have equal sizes. A pixel differs if any of R, G, B, A differs. PSNR,
/// SSIM and FLIP are computed from R, G and B, and only if pixels differ. If a picture has transparency,
/// they are measured over black and over white, and the worse result counts. If several pixels or windows
/// are equally bad, the first in reading order is reported. The result is independent of the thread count.
[[nodiscard]] Metrics measure(const frame::Image& a, const frame::Image& b,
                              const scene::Tolerance& tolerance, Measures measures = Measures::all);

/// Compares pictures of which at least one has more than 8 bits per channel. `difference`: largest channel
/// difference of each pixel in units of 1/255. `a` and `b`: 8-bit versions for display.
[[nodiscard]] Metrics measureDifferences(const std::vector<float>& difference, const frame::Image& a,
                                         const frame::Image& b, const scene::Tolerance& tolerance,
                                         Measures measures = Measures::all);

/// Returns the fraction of pixels that may differ. This is maxDiffRatio if it is given, 1 if only
/// maxDiffPixels is given, and otherwise 0.02.
[[nodiscard]] double allowedRatio(const scene::Tolerance& tolerance);

/// Returns one clause for each violated bound, with hardFail first: "2.31% of the pixels differ by more
/// than 12 (maxDiffRatio is 0.02)". The list is empty if all bounds hold. `width` and `height`: size of the
/// pictures.
[[nodiscard]] std::vector<std::string> brokenBounds(const Metrics& metrics,
                                                    const scene::Tolerance& tolerance, int width,
                                                    int height);

/// Limits for pictures of two machines with equal fingerprints: max difference of each channel, max
/// fraction of differing pixels, and max mean FLIP error. The limits are larger than all observed
/// differences between such machines (1 of 255 on 0.96% of the pixels) and below what is visible.
inline constexpr int nearChannel = 2;
inline constexpr double nearRatio = 0.02;
inline constexpr double nearFlipMean = 0.002;
/// Returns one clause for each violated limit of nearChannel, nearRatio and nearFlipMean.
[[nodiscard]] std::vector<std::string> brokenNearness(const Metrics& metrics, int width, int height);

}  // namespace simreel::golden
