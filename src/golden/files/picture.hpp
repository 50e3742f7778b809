#pragma once
#include "frame/image.hpp"
#include "golden/files/exr_layers.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::golden {

/// Max number of pixels. A file that declares more is damaged or too large to compare.
inline constexpr std::size_t maxPicturePixels = std::size_t{1} << 28;

/// Number format of a picture file.
enum class Depth {
  unorm8,   ///< integers from 0 to 255, sRGB encoded
  unorm16,  ///< integers from 0 to 65535, sRGB encoded
  linear,   ///< floats of linear light, where 1 is screen white; any value is allowed
};

/// A decoded picture file. Row 0 is at the top.
struct Picture {
  /// 8-bit version for display: values of more than 8 bits per channel are rounded, linear light is clamped
  /// and sRGB encoded
  frame::Image image;
  Depth depth = Depth::unorm8;
  /// RGBA of each pixel if the file has more than 8 bits per channel; otherwise empty
  std::vector<float> values;
  /// colour interpretation that the file declares, from colourWords()
  std::string colours;
  std::string note = {};                  ///< parts of the file that were not decoded; may be empty
  std::vector<PictureLayer> layers = {};  ///< layers of an OpenEXR file
  bool layered = false;                   ///< true if the file format can have layers
};

/// Reads a whole file into `bytes` and reuses the memory of `bytes`. Throws UserError(inputOutput) if the
/// file is unreadable, a pipe or a device. The message is one line that starts with `what` ("baseline") and
/// the path.
void readBytes(const std::filesystem::path& path, const char* what, std::string& bytes);

/// Decodes PNG (8 and 16 bits, grey, palette, alpha), JPEG, Radiance HDR, OpenEXR and PNM. The first bytes
/// of the file determine the format. Throws UserError(inputOutput) for other formats, damaged files,
/// pictures larger than maxPicturePixels (OpenEXR, Radiance and PNM: more than 16384 pixels per side), and
/// files for which placeholderProblem() returns a description, such as Git LFS pointers.
[[nodiscard]] Picture decodePicture(std::string_view bytes, const char* what, const std::string& name);
[[nodiscard]] Picture readPicture(const std::filesystem::path& path, const char* what);

/// Throws the same errors as decodePicture() if the file is visibly incomplete or of another format. Does
/// not decode the pixels.
void checkPicture(std::string_view bytes, const char* what, const std::string& name);

/// True if the file name has the extension of a picture. Includes formats that decodePicture() rejects with
/// a message, so that no picture is silently skipped.
[[nodiscard]] bool isPictureName(const std::filesystem::path& file);

/// True if the file has the first bytes of a PNG, JPEG or OpenEXR picture, regardless of its name. False
/// for unreadable files and for PNM and Radiance, whose first bytes also occur in text files.
[[nodiscard]] bool holdsPicture(const std::filesystem::path& file);

/// Returns a hash of size, depth, all four channels and layers (32 hexadecimal digits). It does not depend
/// on file format and encoder.
[[nodiscard]] std::string pictureHash(const Picture& picture);

/// Returns RGBA values in units of 1/255 of the sRGB encoded range. Deep pictures have fractional values.
/// Light above white exceeds 255, because the sRGB curve is extended.
[[nodiscard]] std::vector<float> inUnits(const Picture& picture);

/// Returns a larger picture with the given one at the top left and transparent black elsewhere.
[[nodiscard]] Picture padded(const Picture& picture, int width, int height);

}  // namespace simreel::golden
