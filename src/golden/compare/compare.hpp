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

/// Compares two pictures of equal size (a precondition). A pixel differs if any of R, G, B, A differs.
/// PSNR, SSIM and FLIP are computed from R, G and B, and only if pixels differ. If a picture has
/// transparency, they are measured over black and over white, and the worse result counts. Of several
/// equally bad pixels or windows, the first in reading order is reported. The result is independent of the
/// thread count.
[[nodiscard]] Metrics measure(const frame::Image& a, const frame::Image& b,
                              const scene::Tolerance& tolerance, Measures measures = Measures::all);

/// Compares deep pictures. `apart`: largest channel difference of each pixel in units of 1/255. `a` and
/// `b`: 8-bit versions for display.
[[nodiscard]] Metrics measureApart(const std::vector<float>& apart, const frame::Image& a,
                                   const frame::Image& b, const scene::Tolerance& tolerance,
                                   Measures measures = Measures::all);

/// Returns the fraction of pixels that may differ: maxDiffRatio if given; 1 if only maxDiffPixels is given;
/// else 0.02.
[[nodiscard]] double allowedRatio(const scene::Tolerance& tolerance);

/// Returns one clause for each violated bound, hardFail first: "2.31% of the pixels differ by more than 12
/// (maxDiffRatio is 0.02)". The list is empty if all bounds hold. `width` and `height`: size of the
/// pictures.
[[nodiscard]] std::vector<std::string> brokenBounds(const Metrics& metrics,
                                                    const scene::Tolerance& tolerance, int width,
                                                    int height);

/// Limits for pictures of two machines with equal fingerprints: difference of each channel, fraction of
/// differing pixels, mean FLIP error. The limits are larger than all observed differences between such
/// machines (1 of 255 on 0.96% of the pixels) and below what is visible.
inline constexpr int nearChannel = 2;
inline constexpr double nearRatio = 0.02;
inline constexpr double nearFlipMean = 0.002;
/// Returns one clause for each violated limit of nearChannel, nearRatio and nearFlipMean.
[[nodiscard]] std::vector<std::string> brokenNearness(const Metrics& metrics, int width, int height);

}  // namespace simreel::golden
