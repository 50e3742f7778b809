#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Decoded image: rows from the top, RGBA with 8 bits per channel, sRGB as in the file. rgba.size() is 4 *
/// width * height.
struct Picture {
  glm::ivec2 size{0, 0};
  std::vector<std::uint8_t> rgba;

  /// Returns the luma of a pixel, 0 to 255: (54 r + 183 g + 19 b) / 256, in integers, so that every machine
  /// gets the same value.
  [[nodiscard]] int level(int x, int y) const {
    const std::uint8_t* p = &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                                       static_cast<std::size_t>(x))];
    return (54 * p[0] + 183 * p[1] + 19 * p[2]) >> 8;
  }
};

/// Returns true if the bytes start with the signature of a supported format: PNG, JPEG, PNM or BMP.
[[nodiscard]] bool beginsAsPicture(std::string_view bytes);

/// Reads a PNG or JPEG image, or a BMP or PNM image with 8 bits per channel. `what` is the use of the image
/// in messages ("texture", "fuel map"). Throws UserError: the errors of readFile(); inputOutput if the file
/// is not an image or declares more pixels than its bytes can encode; device if a side exceeds `maxSide` or
/// the image has more than 2^27 pixels; usage if a pixel is not opaque.
[[nodiscard]] Picture loadPicture(const std::filesystem::path& file, const char* what, int maxSide);
/// Decodes an image from a file's bytes. Its pixels need not be opaque. `name` is the name of the file in
/// messages.
[[nodiscard]] Picture decodePicture(std::string_view bytes, const std::string& name, const char* what,
                                    int maxSide);

/// Brightness of each pixel of an image, 0 to `white`, with rows from the top. It has 16 bits per channel
/// if the file is a 16-bit PNG, otherwise 8.
struct Levels {
  glm::ivec2 size{0, 0};
  std::vector<std::uint16_t> values;
  double white = 255;

  [[nodiscard]] std::uint16_t at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                  static_cast<std::size_t>(x)];
  }
};

/// Reads an image whose pixels are interpreted as numbers. Throws the errors of loadPicture().
[[nodiscard]] Levels loadLevels(const std::filesystem::path& file, const char* what, int maxSide);

/// Resamples an image to a grid like levelsOnGrid(), but returns fractions of `white`.
[[nodiscard]] std::vector<double> sharesOnGrid(const Levels& levels, glm::ivec2 grid);

/// Resamples an image to a grid: returns for each cell the level (0 to 255) of the pixel nearest to the
/// cell's centre, x fastest. An image of the same size as the grid is copied pixel by pixel.
[[nodiscard]] std::vector<std::uint8_t> levelsOnGrid(const Picture& picture, glm::ivec2 grid);

}  // namespace simreel::sim
