#include "sim/grid/picture_file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/png.hpp"
#include "base/text.hpp"
#include "sim/grid/stb_picture.hpp"

#include <algorithm>
#include <limits>

namespace simreel::sim {

namespace {

constexpr int texelLimit = 1 << 27;  ///< Maximum number of texels in a buffer on common devices.

/// Returns true if a BMP file contains all bytes of its rows. stb_image would replace missing bytes by
/// zeros.
bool bmpIsWhole(std::string_view bytes, glm::ivec2 size) {
  const auto number = [&](std::size_t at, std::size_t length) {
    std::size_t value = 0;
    for (std::size_t k = length; k-- > 0;)
      value = value << 8U | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    return value;
  };
  const bool old = number(14, 4) == 12;  // true for a BMP file with the OS/2 header
  const std::size_t bits = number(old ? 24 : 28, 2);
  const std::size_t row = (static_cast<std::size_t>(size.x) * bits + 31) / 32 * 4;
  return number(10, 4) + row * static_cast<std::size_t>(size.y) <= bytes.size();
}

/// Returns the maximum number of pixels that a file of this size can encode.
double pixelsIn(std::string_view bytes) {
  const auto size = static_cast<double>(bytes.size());
  if (bytes.starts_with('P')) return size;
  if (bytes.starts_with("BM"))
    return size * 8;  // A pixel takes at least one bit; compressed BMP files are not supported.
  if (!bytes.starts_with('\x89'))
    return size * 512;  // In a JPEG, a block of 8 x 8 pixels takes at least one bit.
  const auto header = pngHeaderOf(bytes);
  constexpr int channels[] = {1, 0, 3, 1, 2, 0, 4};  // Number of channels, indexed by PNG colour type.
  const int bits = header && header->colour < 7 ? header->depth * channels[header->colour] : 0;
  return bits == 0 ? 0 : size * 1032 * 8 / bits;  // Deflate expands one byte to at most 1032 bytes.
}

/// Returns true if width, height and maximum value of a PNM image (P5, P6) have at most nine digits each,
/// because stb_image overflows on longer numbers. The numbers are separated by white space and comments.
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

[[noreturn]] void refusePicture(const char* what, const std::string& name, const std::string& why) {
  fail(ExitCode::inputOutput, "the {} {} is not a picture this program reads ({}); use PNG or JPEG", what,
       name, oneLine(why));  // The message of stb_image may quote the file's contents.
}

/// Throws an error for a PNG whose pixels use colour indices beyond the palette, because stb_image would
/// read uninitialized memory for them. The indices are obtained by decoding the same file as a grey image.
void checkPalette(std::string_view bytes, glm::ivec2 size, const std::string& name, const char* what) {
  const auto header = pngHeaderOf(bytes);
  if (!header || header->colour != 3) return;
  constexpr std::size_t colourAt = 25;
  const int depth = header->depth;
  std::string grey(pngSignature);
  std::size_t colours = 0;
  for (std::string_view rest = bytes.substr(pngSignature.size()); rest.size() >= PngChunk::frame;) {
    const auto chunk = takePngChunk(rest);
    if (!chunk) return;
    if (chunk->type == "PLTE") colours = chunk->data.size() / 3;
    if (chunk->type == "IHDR" || chunk->type == "IDAT" || chunk->type == "IEND") grey += chunk->whole;
  }
  if (depth > 8 || colours >= std::size_t{1} << static_cast<unsigned>(depth)) return;
  grey[colourAt] = 0;
  const auto numbers = stbDecode<std::uint8_t>(grey, size, 1);
  if (!numbers) return;  // If this decoding fails, decoding the picture itself reports the error.
  const int scale = 255 / ((1 << depth) - 1);
  const auto width = static_cast<std::size_t>(size.x);
  for (std::size_t at = 0; at < numbers->size(); ++at)
    if (const std::size_t number = (*numbers)[at] / scale; number >= colours)
      refusePicture(what, name,
                    fmt::format("its pixel at column {}, row {} has colour {}, and its palette has {}",
                                at % width, at / width, number, colours));
}

/// Checks the image's header against the file size and the limits, and returns the image's size.
glm::ivec2 checkedSize(std::string_view bytes, const std::string& name, const char* what, int maxSide) {
  const auto refuse = [&](const std::string& why) { refusePicture(what, name, why); };
  if (bytes.size() > std::size_t{1} << 30) refuse("larger than 1 GiB");
  if (bytes.starts_with('P') && !pnmNumbersFit(bytes)) refuse("a number of more than nine digits");
  // First reads only the header, because a small file may declare an image that takes all memory.
  const auto size = stbSize(bytes);
  if (!size) refuse(stbReason());
  auto [width, height] = std::pair(size->x, size->y);
  if (bytes.starts_with("BM") && height < 0 && height >= -maxSide)
    height = -height;  // A negative height means that rows start at the top.
  if (width < 1 || height < 1) refuse("no width or no height");
  if (std::max(width, height) > maxSide)
    fail(ExitCode::device, "the {} {} is {}x{}, above the limit of {}x{} here", what, name, width, height,
         maxSide, maxSide);
  if (static_cast<double>(width) * height > pixelsIn(bytes))
    refuse(fmt::format("{}x{} pixels do not fit in its {} bytes", width, height, bytes.size()));
  if (static_cast<double>(width) * height > texelLimit)
    fail(ExitCode::device, "the {} {} of {}x{} pixels is above the limit of {} pixels; make it smaller",
         what, name, width, height, texelLimit);
  if (bytes.starts_with("BM") && !bmpIsWhole(bytes, {width, height})) refuse("it is cut off");
  // stb_image 2.27 reads past the end of such a file.
  if (bytes.starts_with('P') && stbIsDeep(bytes))
    fail(ExitCode::inputOutput,
         "the {} {} is a PNM picture of 16 bits, which this program does not read; use PNG", what, name);
  checkPalette(bytes, {width, height}, name, what);
  return {width, height};
}

/// Decodes to RGBA with the channel type `Value`.
template <class Value>
std::vector<Value> decodedChannels(std::string_view bytes, const std::string& name, const char* what,
                                   glm::ivec2 size) {
  auto values = stbDecode<Value>(bytes, size);
  if (!values)
    refusePicture(what, name,
                  stbFoundMore()
                      ? fmt::format("it holds more than the {}x{} pixels of its header", size.x, size.y)
                      : stbReason());
  return std::move(*values);
}

/// Throws an error if a pixel is not opaque.
template <class Value>
void checkOpaque(const std::vector<Value>& rgba, const std::string& name, const char* what) {
  std::size_t seenThrough = 0;
  for (std::size_t at = 3; at < rgba.size(); at += 4)
    seenThrough += rgba[at] < std::numeric_limits<Value>::max() ? 1 : 0;
  if (seenThrough > 0)
    fail(ExitCode::usage,
         "the {} {} is transparent in {} of {} pixels{}; flatten it onto a colour, for example with "
         "ImageMagick: convert picture.png -background white -flatten flat.png",
         what, name, seenThrough, rgba.size() / 4,
         what == std::string_view("texture")
             ? ", which needs a material with \"alpha\": \"cut\" or \"blend\""
             : "");
}

/// Returns the index of the pixel nearest to a cell's centre, computed in integer arithmetic. The centre is
/// at (2 cell + 1) / (2 cells), as a fraction of the image's width.
int nearestPixel(int cell, int cells, int pixels) {
  return static_cast<int>((2LL * cell + 1) * pixels / (2LL * cells));
}

}  // namespace

bool beginsAsPicture(std::string_view bytes) {
  return bytes.starts_with("\x89PNG") || bytes.starts_with("\xff\xd8") || bytes.starts_with("BM") ||
         bytes.starts_with("P5") || bytes.starts_with("P6");
}

Picture loadPicture(const std::filesystem::path& file, const char* what, int maxSide) {
  Picture picture = decodePicture(readFile(file, what), file.string(), what, maxSide);
  checkOpaque(picture.rgba, file.string(), what);
  return picture;
}

Picture decodePicture(std::string_view bytes, const std::string& name, const char* what, int maxSide) {
  const glm::ivec2 size = checkedSize(bytes, name, what, maxSide);
  return {size, decodedChannels<std::uint8_t>(bytes, name, what, size)};
}

Levels loadLevels(const std::filesystem::path& file, const char* what, int maxSide) {
  const std::string bytes = readFile(file, what), name = file.string();
  Levels levels;
  levels.size = checkedSize(bytes, name, what, maxSide);
  const auto convert = [&](const auto& rgba) {
    checkOpaque(rgba, name, what);
    levels.white = std::numeric_limits<typename std::decay_t<decltype(rgba)>::value_type>::max();
    levels.values.reserve(rgba.size() / 4);
    for (std::size_t at = 0; at < rgba.size(); at += 4)
      levels.values.push_back(static_cast<std::uint16_t>(
          (54U * rgba[at] + 183U * rgba[at + 1] + 19U * rgba[at + 2]) >>
          8U));  // The weights of the colour channels are the same as in Picture::level().
  };
  if (const auto header = pngHeaderOf(bytes); header && header->depth == 16)
    convert(decodedChannels<std::uint16_t>(bytes, name, what, levels.size));
  else
    convert(decodedChannels<std::uint8_t>(bytes, name, what, levels.size));
  return levels;
}

std::vector<double> sharesOnGrid(const Levels& levels, glm::ivec2 grid) {
  std::vector<double> shares;
  shares.reserve(static_cast<std::size_t>(grid.x) * static_cast<std::size_t>(grid.y));
  for (int y = 0; y < grid.y; ++y)
    for (int x = 0; x < grid.x; ++x)
      shares.push_back(
          levels.at(nearestPixel(x, grid.x, levels.size.x), nearestPixel(y, grid.y, levels.size.y)) /
          levels.white);
  return shares;
}

std::vector<std::uint8_t> levelsOnGrid(const Picture& picture, glm::ivec2 grid) {
  std::vector<std::uint8_t> levels;
  levels.reserve(static_cast<std::size_t>(grid.x) * static_cast<std::size_t>(grid.y));
  for (int y = 0; y < grid.y; ++y)
    for (int x = 0; x < grid.x; ++x)
      levels.push_back(static_cast<std::uint8_t>(
          picture.level(nearestPixel(x, grid.x, picture.size.x), nearestPixel(y, grid.y, picture.size.y))));
  return levels;
}

}  // namespace simreel::sim
