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

/// The first pass of a picture that differs, and where.
struct PassDifference {
  int frame = 0;
  std::string pass, part;  ///< as draw::PassArray has them; only one side has them where `values` is 0
  /// Of the picture: the first of those that show one thing only, or else of all. Where a map differs: one
  /// whose light does, if any; of what is scattered: one of those that a texel stands for.
  std::optional<PicturePlace> pixel;
  std::optional<int> sample;          ///< of what is visible
  std::optional<PicturePlace> texel;  ///< of a map, or of what is scattered
  SeenThing here, there;              ///< what is visible at the pixel
  int values = 0;      ///< words of each side: a key; red, green, blue and coverage; or bytes
  bool light = false;  ///< they are floats
  std::array<std::uint32_t, 4> hereValues{}, thereValues{};
  std::int64_t differing = 0;  ///< pixels (samples of what is visible; texels) of the part, of
  std::int64_t all = 0;        ///< so many
  std::string unstable;        ///< why there is no more: a side does not repeat itself; or empty
};

/// How near a key says something is: nearest plane / depth, of the sun's map 1 at the light; nothing where
/// there is nothing.
[[nodiscard]] std::optional<float> nearnessOf(std::uint32_t key);

/// Nothing where the pictures are equal. Throws UserError(usage) where they are of different sizes.
[[nodiscard]] std::optional<PassDifference> comparePasses(const PassDump& here, const PassDump& there);

}  // namespace simreel::golden
