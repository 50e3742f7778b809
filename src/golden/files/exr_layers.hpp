#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::golden {

/// A channel of an OpenEXR file besides those that make its picture: depth, normals, who is seen.
struct PictureLayer {
  enum class Kind {
    number,   ///< floats, whose differences have a size
    exact,    ///< whole numbers and identifiers: equal or not
    content,  ///< known by `hash` alone
  };
  std::string name;  ///< "Z", "shadows.Z" of a part called shadows
  Kind kind = Kind::number;
  std::vector<std::uint32_t> bits;  ///< of each pixel, of a float or of a whole number
  std::string hash = {};            ///< of what has no value for each pixel
  bool operator==(const PictureLayer&) const = default;

  /// A value, where kind is number.
  [[nodiscard]] float number(std::size_t pixel) const;
  /// 0 where both have the same value at a pixel, else how far apart they are in units of 1/255: more than
  /// 0, and 255 at most.
  [[nodiscard]] double apart(const PictureLayer& other, std::size_t pixel) const;
};

/// All layers of an OpenEXR file, by name. What no value of a pixel tells (deep pixels, other levels,
/// subsampled channels, what lies outside of the display window) is in one whose kind is content. Throws
/// UserError(inputOutput) with `label` ("baseline a.exr") first.
[[nodiscard]] std::vector<PictureLayer> readExrLayers(std::string_view bytes, const std::string& label);

}  // namespace simreel::golden
