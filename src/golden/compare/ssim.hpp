#pragma once
#include "frame/image.hpp"

namespace simreel::golden {

/// Returns the PSNR 10 log10(255^2 / mean squared difference) over R, G and B in dB. It is infinite if the
/// pictures are equal. The pictures must have equal sizes.
[[nodiscard]] double psnr(const frame::Image& a, const frame::Image& b);

/// Returns the structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004) on sRGB values, with an 11x11
/// Gaussian window of sigma 1.5, K1 = 0.01 and K2 = 0.03. The result is the mean over R, G and B and over
/// all pixels whose window is inside the picture, as in scikit-image's structural_similarity with
/// gaussian_weights, sigma 1.5 and use_sample_covariance=False. Along a side shorter than 11 pixels, every
/// window counts and the picture is mirrored. (ffmpeg's ssim filter uses the same formula over 8x8 blocks.)
/// Equal pictures give 1. The pictures must have equal sizes.
[[nodiscard]] double ssim(const frame::Image& a, const frame::Image& b);

}  // namespace simreel::golden
