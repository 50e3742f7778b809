#pragma once
#include "frame/image.hpp"
#include "golden/files/exr_layers.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::golden {

/// Pixels in all; a file that claims more is damaged, or nothing to compare.
inline constexpr std::size_t mostPicturePixels = std::size_t{1} << 28;

/// What the numbers of a picture file are.
enum class Depth {
  unorm8,   ///< 0 to 255, sRGB
  unorm16,  ///< 0 to 65535, sRGB
  linear,   ///< light, 1 is a screen's white; any number
};

/// A picture of any file. Rows from the top.
struct Picture {
  frame::Image image;  ///< as a screen shows it: deeper ones are rounded, light is clamped and encoded
  Depth depth = Depth::unorm8;
  std::vector<float> values;  ///< RGBA of each pixel where the file is deeper than 8 bits; else empty
  std::string colours;        ///< colourWords()
  std::string note = {};      ///< what of the file is not in it; or empty
  std::vector<PictureLayer> layers = {};  ///< of OpenEXR
  bool layered = false;                   ///< whether the file is of a kind that may have layers
};

/// Reads a whole file into `bytes`, whose memory is used again. Throws UserError(inputOutput) in one line
/// that begins with `what` ("baseline") and the path: for what cannot be read, and for a pipe or a device.
void readBytes(const std::filesystem::path& path, const char* what, std::string& bytes);

/// PNG (8 and 16 bits, grey, palette, alpha), JPEG, Radiance HDR, OpenEXR and PNM, told apart by their
/// first bytes. Throws UserError(inputOutput) for what is none of them, is damaged, larger than
/// mostPicturePixels (OpenEXR, Radiance and PNM: than 16384 on a side), or something else in its place
/// (standsForAnother()).
[[nodiscard]] Picture decodePicture(std::string_view bytes, const char* what, const std::string& name);
[[nodiscard]] Picture readPicture(const std::filesystem::path& path, const char* what);

/// Throws as decodePicture does where the file is visibly not whole or not one of these kinds, without
/// decoding its pixels.
void checkPicture(std::string_view bytes, const char* what, const std::string& name);

/// Whether the name ends as those of pictures do: of kinds that decodePicture reads and of others, which it
/// refuses by name, so that none is passed over.
[[nodiscard]] bool isPictureName(const std::filesystem::path& file);

/// Whether a file begins as a picture of a kind that decodePicture reads, whatever its name. False for what
/// cannot be read, and for text (PNM and Radiance begin as that, too).
[[nodiscard]] bool holdsPicture(const std::filesystem::path& file);

/// Hash of size, depth, all four channels and layers, independent of the file's kind and encoder. 32
/// hexadecimal digits.
[[nodiscard]] std::string pictureHash(const Picture& picture);

/// Values in units of 1/255 of the encoded range, RGBA: deeper pictures have fractions, light above white
/// is above 255 (the sRGB curve goes on).
[[nodiscard]] std::vector<float> inUnits(const Picture& picture);

/// The picture at the top left of a larger one, the rest transparent black.
[[nodiscard]] Picture padded(const Picture& picture, int width, int height);

}  // namespace simreel::golden
