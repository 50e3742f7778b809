#pragma once
#include "golden/trace/passes.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace simreel::golden {

struct PicturePlace {
  int x = 0, y = 0;
  bool operator==(const PicturePlace&) const = default;
};

/// First differing pass of two pictures, and the position of the first difference.
struct PassDifference {
  int frame = 0;
  std::string pass, part;  ///< names of the pass and of its part, as in draw::PassArray; if `values` is 0,
                           ///< only one side has this array
  /// Pixel of the picture that represents the difference. Normally this is the first differing pixel that
  /// shows only one object, or, if there is none, the first differing pixel. For a shadow map it is the
  /// first pixel whose light differs, if any. For bloom it is one of the pixels that the texel covers.
  std::optional<PicturePlace> pixel;
  std::optional<int> sample;          ///< index of the sample, for the visibility pass
  std::optional<PicturePlace> texel;  ///< texel of a shadow map or bloom level
  SeenThing here, there;              ///< object and primitive that the pixel shows on each side
  /// number of words per side: one for a depth key, four for red, green, blue and coverage, or one for
  /// bytes
  int values = 0;
  bool light = false;  ///< true if the words are floats (linear light)
  std::array<std::uint32_t, 4> hereValues{}, thereValues{};
  /// number of differing pixels of the array, or of samples (visibility) or texels (maps)
  std::int64_t differing = 0;
  std::int64_t all = 0;  ///< total number of pixels, samples or texels
  /// reason if the comparison stopped because a side is not repeatable; may be empty
  std::string unstable;
};

/// Converts a depth key to nearness. Nearness is the near plane distance divided by the depth. In the sun's
/// shadow map it is 1 at the light. Returns nothing if the key stands for an empty sample.
[[nodiscard]] std::optional<float> nearnessOf(std::uint32_t key);

/// Returns the first differing pass, or nothing if the pictures are equal. Throws UserError(usage) if their
/// sizes differ.
[[nodiscard]] std::optional<PassDifference> comparePasses(const PassDump& here, const PassDump& there);

}  // namespace simreel::golden
