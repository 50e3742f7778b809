#pragma once
#include "frame/image.hpp"
#include "golden/result.hpp"
#include "scene/test.hpp"

#include <string>
#include <vector>

namespace simreel::golden {

/// What is measured between pictures that differ. The quick ones are all that need no filters.
enum class Measures { all, quick };

/// Compares two pictures of equal size (an invariant; check before). A pixel differs where any of R, G, B,
/// A does; PSNR, SSIM and FLIP cost time only where some do. They are of R, G and B; where a pixel is not
/// opaque they are of the pictures over black and over white, and the worse of the two. The first of
/// several equally bad pixels or windows, in reading order, is named. The result does not depend on the
/// thread count.
[[nodiscard]] Metrics measure(const frame::Image& a, const frame::Image& b,
                              const scene::Tolerance& tolerance, Measures measures = Measures::all);

/// The same where each pixel's largest difference of a channel is known, in units of 1/255: of deeper
/// pictures than `a` and `b`, which are what screens show of them.
[[nodiscard]] Metrics measureApart(const std::vector<float>& apart, const frame::Image& a,
                                   const frame::Image& b, const scene::Tolerance& tolerance,
                                   Measures measures = Measures::all);

/// Fraction of all pixels that may differ: maxDiffRatio; 1 where only maxDiffPixels is given; 0.02 where
/// neither is.
[[nodiscard]] double allowedRatio(const scene::Tolerance& tolerance);

/// One clause for each bound that does not hold, hardFail first: "2.31% of the pixels differ by more than
/// 12 (maxDiffRatio is 0.02)". Empty: within the tolerance. Width and height are those of the pictures.
[[nodiscard]] std::vector<std::string> brokenBounds(const Metrics& metrics,
                                                    const scene::Tolerance& tolerance, int width,
                                                    int height);

/// How far apart pictures of two machines with the same fingerprints may be: each channel of each pixel,
/// fraction of the pixels, mean FLIP error. Larger than anything seen between such machines (1 of 255 on
/// 0.96% of the pixels), smaller than what anybody sees.
inline constexpr int nearChannel = 2;
inline constexpr double nearRatio = 0.02;
inline constexpr double nearFlipMean = 0.002;
/// One clause for each of them that does not hold.
[[nodiscard]] std::vector<std::string> brokenNearness(const Metrics& metrics, int width, int height);

}  // namespace simreel::golden
