#pragma once
#include "golden/compare/allowance.hpp"
#include "golden/compare/compare.hpp"
#include "golden/files/picture.hpp"
#include "golden/result.hpp"
#include "scene/test.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace simreel::golden {

/// Two pictures held against each other.
struct Comparison {
  Metrics metrics;    ///< of the pixels that count
  std::string sizes;  ///< "the picture is 20x12, its baseline 19x12"; empty: equal
  /// What the files say their numbers mean, where that differs: "the colour profile ..., which is not
  /// compared".
  std::string colours;
  /// Layers that one of them lacks or whose differences have no size, which no bound excuses; empty: none.
  std::string layers;
  std::string layerNote;        ///< layers that differ, and where most
  frame::Image a, b;            ///< as screens show them; padded to the larger width and height
  std::vector<Excuse> excuses;  ///< of each pixel; empty: none
  std::vector<std::uint8_t>
      apart;  ///< largest difference of a channel, rounded up: what `a` and `b` may not show
};

/// Compares pictures of any depth. Where sizes differ both are padded at the right and below to the larger,
/// and what one has beside the other differs. Pixels with an excuse count as equal. A deeper picture's
/// differences are fractions of 1/255, and those of layers of 1/255 of their unit; PSNR, SSIM and FLIP are
/// of what a screen shows.
[[nodiscard]] Comparison compare(const Picture& baseline, const Picture& picture,
                                 const scene::Tolerance& tolerance, const Allowance& allowance,
                                 Measures measures = Measures::all);

/// As the other differenceImage(), and where a pixel is excused its reason: violet inside a mask, light
/// grey on a smoothed edge, brown where it moved.
[[nodiscard]] frame::Image differenceImage(const Comparison& comparison);
/// FLIP's map, black (0) over violet and orange to light yellow (1).
[[nodiscard]] frame::Image flipImage(const Comparison& comparison);

}  // namespace simreel::golden
