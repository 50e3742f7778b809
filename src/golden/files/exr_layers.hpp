#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::golden {

/// A channel of an OpenEXR file that is not part of the colour picture, such as depth, normals or object
/// ids.
struct PictureLayer {
  enum class Kind {
    number,   ///< floats, whose differences have a magnitude
    exact,    ///< integers and identifiers, which are equal or not
    content,  ///< data of which only `hash` is known
  };
  std::string name;  ///< channel name: "Z", or "shadows.Z" for a part named shadows
  Kind kind = Kind::number;
  std::vector<std::uint32_t> bits;  ///< value of each pixel: the bits of a float or an integer
  std::string hash = {};            ///< hash of data that has no value for each pixel
  bool operator==(const PictureLayer&) const = default;

  /// Returns a pixel's value as a float. Requires Kind::number.
  [[nodiscard]] float number(std::size_t pixel) const;
  /// Returns the difference of the two layers at a pixel in units of 1/255. It is 0 if the values are
  /// equal, and otherwise more than 0 and at most 255.
  [[nodiscard]] double difference(const PictureLayer& other, std::size_t pixel) const;
};

/// Reads all layers of an OpenEXR file, sorted by name. Data that is not one value for each pixel (deep
/// pixels, further levels, subsampled channels, pixels outside of the display window) becomes layers of
/// Kind::content. Throws UserError(inputOutput) with a message that starts with `label` ("baseline a.exr").
[[nodiscard]] std::vector<PictureLayer> readExrLayers(std::string_view bytes, const std::string& label);

}  // namespace simreel::golden
