#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Rows from the top, RGBA, 8 bits each, as the file has them (sRGB): rgba.size() == 4 * width * height.
struct Picture {
  glm::ivec2 size{0, 0};
  std::vector<std::uint8_t> rgba;

  /// Luma of a pixel, 0 to 255: (54 r + 183 g + 19 b) / 256, in integers, so every machine reads the same
  /// map.
  [[nodiscard]] int level(int x, int y) const {
    const std::uint8_t* p = &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                                       static_cast<std::size_t>(x))];
    return (54 * p[0] + 183 * p[1] + 19 * p[2]) >> 8;
  }
};

/// Whether bytes begin as a format that is read: PNG, JPEG, PNM or BMP.
[[nodiscard]] bool beginsAsPicture(std::string_view bytes);

/// Reads PNG, JPEG, BMP and PNM of 8 bits. `what` names its use in messages ("texture", "fuel map"). Throws
/// UserError: what readFile says for a file that cannot be read, inputOutput for one that is no picture or
/// promises more pixels than its bytes can hold, device for one wider or higher than `maxSide` or of more
/// than 2^27 pixels, usage for one with a pixel that is not opaque.
[[nodiscard]] Picture loadPicture(const std::filesystem::path& file, const char* what, int maxSide);
/// The same from the file's bytes, opaque or not; `name` is what messages call it.
[[nodiscard]] Picture decodePicture(std::string_view bytes, const std::string& name, const char* what,
                                    int maxSide);

/// How light each pixel of a picture is: 0 to `white`, rows from the top. Of 16 bits a channel where the
/// file is a PNG that has them, else of 8.
struct Levels {
  glm::ivec2 size{0, 0};
  std::vector<std::uint16_t> values;
  double white = 255;

  [[nodiscard]] std::uint16_t at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                  static_cast<std::size_t>(x)];
  }
};

/// Reads a picture whose pixels are numbers. Throws as loadPicture() does.
[[nodiscard]] Levels loadLevels(const std::filesystem::path& file, const char* what, int maxSide);

/// Fractions of white of a picture drawn onto a grid, as levelsOnGrid().
[[nodiscard]] std::vector<double> sharesOnGrid(const Levels& levels, glm::ivec2 grid);

/// Levels (0 to 255) of a picture drawn onto a grid: nearest pixel to the middle of each cell, x fastest. A
/// picture of the grid's size is taken pixel for pixel.
[[nodiscard]] std::vector<std::uint8_t> levelsOnGrid(const Picture& picture, glm::ivec2 grid);

}  // namespace simreel::sim
