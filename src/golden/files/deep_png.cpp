// PNG of 16 bits a channel, which stb_image reads; its decoder of sim/grid is for 8.
#include "base/error.hpp"
#include "base/text.hpp"
#include "golden/files/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace {

/// Most bytes that the decoder may ask for at once, so that a few compressed bytes never become gigabytes.
thread_local std::size_t maxBytes = 0;

void* takeForStb(std::size_t size) {
  return size <= maxBytes ? std::malloc(size) : nullptr;
}
void* resizeForStb(void* data, std::size_t size) {
  return size <= maxBytes ? std::realloc(data, size) : nullptr;
}

}  // namespace

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_ONLY_PNG
#define STBI_MALLOC(size) takeForStb(size)
#define STBI_REALLOC(data, size) resizeForStb(data, size)
#define STBI_FREE(data) std::free(data)
#include <stb/stb_image.h>

namespace simreel::golden {

Picture decodeDeepPng(std::string_view bytes, const std::string& label) {
  const auto refuse = [&](const std::string& why) {
    fail(ExitCode::inputOutput, "{} cannot be decoded ({})", label, oneLine(why));
  };
  constexpr std::size_t forHeaders = 1 << 16;
  if (bytes.size() > std::size_t{1} << 30) refuse("larger than 1 GiB");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  maxBytes = forHeaders;
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) refuse(stbi_failure_reason());
  if (width < 1 || height < 1) refuse("no width or no height");
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  if (pixels > mostPicturePixels)
    refuse(fmt::format("{}x{}, more than {} million pixels", width, height, mostPicturePixels / 1'000'000));
  // deflate makes at most 1032 bytes of one; a pixel has at least two.
  if (static_cast<double>(pixels) * 2 > static_cast<double>(bytes.size()) * 1032)
    refuse(fmt::format("{}x{} pixels do not fit in its {} bytes", width, height, bytes.size()));
  maxBytes = std::max(8 * (pixels + 64 * std::size_t(width + height + 64)), 2 * bytes.size()) + forHeaders;
  const std::unique_ptr<stbi_us, decltype(&stbi_image_free)> texels(
      stbi_load_16_from_memory(data, size, &width, &height, &channels, 4), &stbi_image_free);
  if (!texels) refuse(stbi_failure_reason());
  Picture picture{{width, height, {}}, Depth::unorm16, {}, {}, {}};
  picture.values.assign(texels.get(), texels.get() + 4 * pixels);
  picture.image.bytes.resize(4 * pixels);
  for (std::size_t i = 0; i < 4 * pixels; ++i)
    picture.image.bytes[i] = static_cast<std::uint8_t>((texels.get()[i] + 128U) / 257U);
  return picture;
}

}  // namespace simreel::golden
