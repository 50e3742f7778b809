#pragma once
#include "golden/files/picture.hpp"

#include <cstdint>
#include <vector>

namespace simreel::golden {

/// Reason why a comparison ignores a differing pixel.
enum class Excuse : std::uint8_t {
  none,
  masked,       ///< inside a mask, where pixels are not compared
  antialiased,  ///< on an antialiased edge
  moved,        ///< each of the two colours occurs in the other picture, within the search radius
};

/// Differences to ignore when two pictures are compared.
struct Allowance {
  std::vector<std::uint8_t> mask;  ///< 1 for each pixel to ignore, row by row from the top; if empty, all
                                   ///< pixels count
  /// Ignores pixels on antialiased edges, which are detected as in pixelmatch, odiff and Playwright (V.
  /// Vysniauskas, "Anti-aliased Pixel and Intensity Slope Detector", 2009). Among the eight neighbours of
  /// such a pixel, at most two are equally bright, one is darker and one is brighter. In both pictures, the
  /// darkest or the brightest neighbour is in a flat area (more than two neighbours of the same colour). A
  /// pixel qualifies if this holds in either picture.
  bool ignoreAntialiased = false;
  /// Search radius in pixels along x and y. A differing pixel is ignored if each of its two colours occurs
  /// within this radius in the other picture, with a difference of at most the tolerance's maxChannelDiff.
  int searchRadius = 0;

  [[nodiscard]] bool none() const { return mask.empty() && !ignoreAntialiased && searchRadius == 0; }
};

/// Returns the excuse of each pixel of two pictures of equal size. `a` and `b` are RGBA values in units of
/// 1/255.
[[nodiscard]] std::vector<Excuse> excuses(const std::vector<float>& a, const std::vector<float>& b,
                                          int width, int height, const Allowance& allowance,
                                          double maxChannelDiff);

}  // namespace simreel::golden
