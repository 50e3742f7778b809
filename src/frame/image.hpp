#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::frame {

/// Image of 8-bit RGBA, sRGB encoded, row 0 at the top: bytes.size() == width * height * 4.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
  bool alpha = false;  ///< true if alpha (straight) is stored in files and hashed; otherwise alpha is
                       ///< ignored
};

/// Text chunks of a PNG as pairs of keyword and value.
using ImageText = std::vector<std::pair<std::string, std::string>>;

/// Encodes an image as PNG: RGBA if image.alpha is true, otherwise RGB. Thread-safe.
[[nodiscard]] std::vector<std::byte> encodePng(const Image& image, const ImageText& text);
/// Raw samples in PNG order: row 0 at the top; grey, RGB or RGBA; 16-bit samples are big endian.
struct PackedPixels {
  glm::ivec2 size;
  int channels;
  int bits;
  std::span<const std::uint8_t> bytes;
  bool linear = false;  ///< true if the samples are linear, false if they are sRGB encoded
};
[[nodiscard]] std::vector<std::byte> encodePng(const PackedPixels& pixels, const ImageText& text);
/// An encoded file together with its pixelHash. Computing both at once costs less than two separate calls.
struct HashedFile {
  std::vector<std::byte> file;
  std::string pixels;
};
[[nodiscard]] HashedFile encodeHashedPng(const Image& image, const ImageText& text);
/// Decodes a PNG, or any other format of stb_image, to RGBA. `alpha` of the result is true unless the image
/// is opaque. On failure, throws UserError(inputOutput) with `name` in the message.
[[nodiscard]] Image decodeImage(std::span<const std::byte> file, const std::string& name);
/// Returns a hash of size and RGB values, and of alpha unless the image is opaque (32 hexadecimal digits).
/// The hash does not depend on the encoder.
[[nodiscard]] std::string pixelHash(const Image& image);

}  // namespace simreel::frame
