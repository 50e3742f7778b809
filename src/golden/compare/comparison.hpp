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

/// Result of comparing two pictures.
struct Comparison {
  Metrics metrics;    ///< differences, measured over the pixels that are not ignored
  std::string sizes;  ///< text such as "the picture is 20x12, its baseline 19x12"; empty if the sizes are
                      ///< equal
  /// Remark if the files declare different colour interpretations (profile, gamma), which the comparison
  /// does not apply. Empty if they declare the same.
  std::string colours;
  /// Layer differences that no tolerance permits. These are layers that only one file has, or layers whose
  /// differences cannot be measured. Empty if no such difference exists.
  std::string layers;
  std::string layerNote;        ///< layers that differ, each with its worst pixel
  frame::Image a, b;            ///< 8-bit versions for display, padded to the larger width and height
  std::vector<Excuse> excuses;  ///< excuse of each pixel; empty if no pixel is excused
  /// Largest channel difference of each pixel in units of 1/255, rounded up. A difference can be
  /// too small to appear in the 8-bit pictures `a` and `b`.
  std::vector<std::uint8_t> difference;
};

/// Compares pictures of any bit depth. Pictures of different sizes are padded at the right and bottom to
/// the larger size, and the padding counts as different. Ignored pixels count as equal. If a picture has
/// more than 8 bits per channel, its differences may be fractions of 1/255. Differences of layers are in
/// 1/255 of the layer's unit. SSIM and FLIP use the 8-bit versions. PSNR uses the 8-bit versions too,
/// except for pictures with more than 8 bits per channel without linear light.
[[nodiscard]] Comparison compare(const Picture& baseline, const Picture& picture,
                                 const scene::Tolerance& tolerance, const Allowance& allowance,
                                 Measures measures = Measures::all);

/// Returns the difference image. Ignored pixels are tinted by reason: violet inside a mask, light grey on
/// an antialiased edge, and brown if found within the search radius.
[[nodiscard]] frame::Image differenceImage(const Comparison& comparison);
/// Returns the FLIP map in false colours: black (0) over violet and orange to light yellow (1).
[[nodiscard]] frame::Image flipImage(const Comparison& comparison);

}  // namespace simreel::golden
