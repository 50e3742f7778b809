#pragma once
#include "frame/image.hpp"

namespace simreel::golden {

/// How far two pictures of equal size are apart (RGB, 8 bits each).
struct Comparison {
  int mostDifferent = 0;    ///< largest difference of one channel, 0 to 255
  int differentPixels = 0;  ///< with any difference
  int pixelsBeyond = 0;     ///< with a channel further apart than the tolerance's
};

/// A channel may be `channel` apart, and at most the share `pixels` of all pixels further.
struct Tolerance {
  int channel = 0;
  double pixels = 0;
};

/// Sizes must be equal (an invariant; check before).
[[nodiscard]] Comparison compareImages(const frame::Image& a, const frame::Image& b,
                                       const Tolerance& tolerance);
[[nodiscard]] bool within(const Comparison& comparison, const frame::Image& image,
                          const Tolerance& tolerance);

}  // namespace simreel::golden
