#include "sim/grid/picture_file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace {

/// Most bytes that the decoder may ask for at once, so that a few compressed bytes never become gigabytes,
/// and whether it asked for more.
thread_local std::size_t maxBytes = 0;
thread_local bool askedForMore = false;

bool allowed(std::size_t size) {
  askedForMore = askedForMore || size > maxBytes;
  return size <= maxBytes;
}
void* takeForStb(std::size_t size) {
  return allowed(size) ? std::malloc(size) : nullptr;
}
void* resizeForStb(void* data, std::size_t size) {
  return allowed(size) ? std::realloc(data, size) : nullptr;
}

}  // namespace

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNM
#define STBI_MALLOC(size) takeForStb(size)
#define STBI_REALLOC(data, size) resizeForStb(data, size)
#define STBI_FREE(data) std::free(data)
#include <stb/stb_image.h>

namespace simreel::sim {

namespace {

constexpr int mostTexels = 1 << 27;  ///< texels that a buffer of a common device has

/// Most pixels that so many bytes of a file can hold.
double pixelsIn(std::string_view bytes) {
  const auto size = static_cast<double>(bytes.size());
  if (bytes.starts_with('P')) return size;
  if (!bytes.starts_with('\x89')) return size * 512;  // JPEG: a block of 8 x 8 pixels takes at least a bit
  if (bytes.size() < 26) return 0;
  constexpr int channels[] = {1, 0, 3, 1, 2, 0, 4};  // by colour type
  const int depth = static_cast<unsigned char>(bytes[24]);
  const int colour = static_cast<unsigned char>(bytes[25]);
  const int bits = colour < 7 ? depth * channels[colour] : 0;
  return bits == 0 ? 0 : size * 1032 * 8 / bits;  // deflate makes at most 1032 bytes of one
}

/// Whether width, height and most value of a PNM picture (P5, P6) have at most nine digits: stb_image
/// overflows on more. White space and comments stand between them.
bool pnmNumbersFit(std::string_view bytes) {
  std::size_t at = 2;
  const auto is = [&](std::string_view any) {
    return at < bytes.size() && any.find(bytes[at]) != std::string_view::npos;
  };
  for (int number = 0; number < 3; ++number) {
    while (is(" \t\n\v\f\r#"))
      at = bytes[at] == '#' ? std::min(bytes.find_first_of("\r\n", at), bytes.size()) : at + 1;
    const std::size_t first = at;
    while (is("0123456789")) ++at;
    if (at - first > 9) return false;
  }
  return true;
}

}  // namespace

Picture loadPicture(const std::filesystem::path& file, const char* what, int maxSide) {
  Picture picture = decodePicture(readFile(file, what), file.string(), what, maxSide);
  std::size_t seenThrough = 0;
  for (std::size_t at = 3; at < picture.rgba.size(); at += 4) seenThrough += picture.rgba[at] < 255 ? 1 : 0;
  if (seenThrough > 0)
    fail(ExitCode::usage,
         "the {} {} is transparent in {} of {} pixels{}; flatten it onto a colour, for example with "
         "ImageMagick: convert picture.png -background white -flatten flat.png",
         what, file.string(), seenThrough, picture.rgba.size() / 4,
         what == std::string_view("texture")
             ? ", which needs a material with \"alpha\": \"cut\" or \"blend\""
             : "");
  return picture;
}

Picture decodePicture(std::string_view bytes, const std::string& name, const char* what, int maxSide) {
  const auto refuse = [&](const std::string& why) {
    fail(ExitCode::inputOutput, "the {} {} is not a picture this program reads ({}); use PNG or JPEG", what,
         name, oneLine(why));  // stb quotes the file
  };
  if (bytes.size() > std::size_t{1} << 30) refuse("larger than 1 GiB");
  int width = 0;
  int height = 0;
  int channels = 0;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  constexpr std::size_t forHeaders = 1 << 16;
  maxBytes = forHeaders;
  if (bytes.starts_with('P') && !pnmNumbersFit(bytes)) refuse("a number of more than nine digits");
  // The header first: a small file may promise a picture that takes all memory.
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) refuse(stbi_failure_reason());
  if (width < 1 || height < 1) refuse("no width or no height");
  if (std::max(width, height) > maxSide)
    fail(ExitCode::device, "the {} {} is {}x{}, above the limit of {}x{} here", what, name, width, height,
         maxSide, maxSide);
  if (static_cast<double>(width) * height > mostTexels)
    fail(ExitCode::device, "the {} {} of {}x{} pixels is above the limit of {} pixels; make it smaller",
         what, name, width, height, mostTexels);
  if (static_cast<double>(width) * height > pixelsIn(bytes))
    refuse(fmt::format("{}x{} pixels do not fit in its {} bytes", width, height, bytes.size()));
  // stb_image 2.27 reads beyond such a picture's end.
  if (bytes.starts_with('P') && stbi_is_16_bit_from_memory(data, size) != 0)
    fail(ExitCode::inputOutput,
         "the {} {} is a PNM picture of 16 bits, which this program does not read; use PNG", what, name);
  // Four channels of 16 bits a pixel, rounded up to whole blocks, or twice the file's bytes.
  maxBytes = std::max(8 * (static_cast<std::size_t>(width) + 64) * (static_cast<std::size_t>(height) + 64),
                      2 * bytes.size()) +
             forHeaders;
  askedForMore = false;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> texels(
      stbi_load_from_memory(data, size, &width, &height, &channels, 4), &stbi_image_free);
  if (!texels && askedForMore)
    refuse(fmt::format("it holds more than the {}x{} pixels of its header", width, height));
  if (!texels) refuse(stbi_failure_reason());
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
