#pragma once
#include "golden/files/picture.hpp"

#include <cstdint>
#include <vector>

namespace simreel::golden {

/// Pixels of a comparison that do not count, though they differ.
enum class Excuse : std::uint8_t {
  none,
  masked,       ///< inside a mask; whether it differs is not looked at
  antialiased,  ///< of a smoothed edge
  moved,        ///< what is there is within the search radius in the other picture, both ways
};

/// What two pictures may differ in.
struct Allowance {
  std::vector<std::uint8_t> mask;  ///< 1 where a pixel does not count, rows from the top; empty: all count
  /// Leaves out pixels of smoothed edges, as V. Vysniauskas finds them ("Anti-aliased Pixel and Intensity
  /// Slope Detector", 2009), which pixelmatch, odiff and Playwright do too: among its eight neighbours at
  /// most two are as bright as it, one is darker and one brighter, and the darkest or the brightest of them
  /// lies in an even patch (more than two neighbours of its own colour) of both pictures. Looked for in
  /// either picture.
  bool ignoreAntialiased = false;
  /// A pixel may be found up to so many pixels away, along x and along y, within the tolerance's
  /// maxChannelDiff; and what the baseline has there must be found in the other picture likewise.
  int searchRadius = 0;

  [[nodiscard]] bool none() const { return mask.empty() && !ignoreAntialiased && searchRadius == 0; }
};

/// Excuse of each pixel of two pictures of equal size whose values are `a` and `b` (RGBA in units of
/// 1/255).
[[nodiscard]] std::vector<Excuse> excuses(const std::vector<float>& a, const std::vector<float>& b,
                                          int width, int height, const Allowance& allowance,
                                          double maxChannelDiff);

}  // namespace simreel::golden
