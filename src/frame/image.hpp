#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::frame {

/// Rows from the top, RGBA, 8 bits each, sRGB encoded: bytes.size() == width * height * 4.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
  bool alpha = false;  ///< whether alpha is part of it, straight; else it is left out of files and hashes
};

/// Text chunks of a PNG, keyword and value.
using ImageText = std::vector<std::pair<std::string, std::string>>;

/// Image -> PNG file, RGBA where alpha is part of it, else RGB. Safe to call from several threads.
[[nodiscard]] std::vector<std::byte> encodePng(const Image& image, const ImageText& text);
/// Numbers as PNG has them, rows from the top, grey, RGB or RGBA, of 16 bits the higher byte first.
struct PackedPixels {
  glm::ivec2 size;
  int channels;
  int bits;
  std::span<const std::uint8_t> bytes;
  bool linear = false;  ///< whether the numbers are proportional to what they stand for, not sRGB
};
[[nodiscard]] std::vector<std::byte> encodePng(const PackedPixels& pixels, const ImageText& text);
/// The same file and its pixelHash, for less than both.
struct HashedFile {
  std::vector<std::byte> file;
  std::string pixels;
};
[[nodiscard]] HashedFile encodeHashedPng(const Image& image, const ImageText& text);
/// PNG (or any format stb_image reads) -> RGBA; alpha is part of it unless it is opaque. `name` is used in
/// the UserError(inputOutput) thrown.
[[nodiscard]] Image decodeImage(std::span<const std::byte> file, const std::string& name);
/// Hash of size and RGB values, and of alpha where that lets something through, independent of the encoder.
/// 32 hexadecimal digits.
[[nodiscard]] std::string pixelHash(const Image& image);

}  // namespace simreel::frame
