#pragma once
#include "frame/image.hpp"

namespace simreel::golden {

/// 10 log10(255^2 / mean squared difference) over R, G and B, in dB; infinite when they are equal. Sizes
/// must be equal (an invariant).
[[nodiscard]] double psnr(const frame::Image& a, const frame::Image& b);

/// Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004): 11x11 Gaussian window of sigma 1.5,
/// K1 = 0.01, K2 = 0.03, on the sRGB values; the mean over R, G and B and over the pixels whose window lies
/// inside. That is scikit-image's structural_similarity with gaussian_weights, sigma 1.5 and
/// use_sample_covariance=False. Along a side below 11 every window counts, and the picture is mirrored.
/// (ffmpeg's ssim filter has the same formula over 8x8 blocks.) 1 when equal. Sizes must be equal.
[[nodiscard]] double ssim(const frame::Image& a, const frame::Image& b);

}  // namespace simreel::golden
