#include "sim/picture_file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"

#include <algorithm>
#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#include <stb/stb_image.h>

namespace simreel::sim {

Picture loadPicture(const std::filesystem::path& file, const char* what, int mostSide) {
  const std::string bytes = readFile(file, what);
  int width = 0;
  int height = 0;
  int channels = 0;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  // The header first: a small file may promise a picture that takes all memory.
  if (stbi_info_from_memory(data, size, &width, &height, &channels) != 0 &&
      std::max(width, height) > mostSide)
    fail(ExitCode::device, "the {} {} is {}x{}, this device allows up to {}x{} (GL_MAX_TEXTURE_SIZE)", what,
         file.string(), width, height, mostSide, mostSide);
  // stb_image 2.27 reads beyond such a picture's end.
  if (bytes.starts_with('P') && stbi_is_16_bit_from_memory(data, size) != 0)
    fail(ExitCode::inputOutput,
         "the {} {} is a PNM picture of 16 bits, which this program does not read; use PNG", what,
         file.string());
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> texels(
      stbi_load_from_memory(data, size, &width, &height, &channels, 4), &stbi_image_free);
  if (!texels)
    fail(ExitCode::inputOutput, "the {} {} is not a picture this program reads ({}); use PNG or JPEG", what,
         file.string(), stbi_failure_reason());
  Picture picture{{width, height}, {}};
  picture.rgba.assign(
      texels.get(), texels.get() + 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return picture;
}

std::vector<std::uint8_t> levelsOnGrid(const Picture& picture, glm::ivec2 grid) {
  std::vector<std::uint8_t> levels;
  levels.reserve(static_cast<std::size_t>(grid.x) * static_cast<std::size_t>(grid.y));
  // (2 x + 1) / (2 grid) of the picture's width, in integers.
  const auto nearest = [](int cell, int cells, int pixels) {
    return static_cast<int>((2LL * cell + 1) * pixels / (2LL * cells));
  };
  for (int y = 0; y < grid.y; ++y)
    for (int x = 0; x < grid.x; ++x)
      levels.push_back(static_cast<std::uint8_t>(
          picture.level(nearest(x, grid.x, picture.size.x), nearest(y, grid.y, picture.size.y))));
  return levels;
}

}  // namespace simreel::sim
