#include "sim/grid/stb_picture.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <type_traits>

namespace {

/// Maximum size of a single allocation of the decoder, and a flag that is set if the decoder requested
/// more.
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
#define STBI_ONLY_BMP
#define STBI_MALLOC(size) takeForStb(size)
#define STBI_REALLOC(data, size) resizeForStb(data, size)
#define STBI_FREE(data) std::free(data)
#include <stb/stb_image.h>

namespace simreel::sim {

namespace {

constexpr std::size_t forHeaders = 1 << 16;

const stbi_uc* dataOf(std::string_view bytes) {
  return reinterpret_cast<const stbi_uc*>(bytes.data());
}

}  // namespace

std::optional<glm::ivec2> stbSize(std::string_view bytes) {
  maxBytes = forHeaders;
  int width = 0, height = 0, channels = 0;
  const int found =
      stbi_info_from_memory(dataOf(bytes), static_cast<int>(bytes.size()), &width, &height, &channels);
  return found == 0 ? std::nullopt : std::optional(glm::ivec2(width, height));
}

bool stbIsDeep(std::string_view bytes) {
  return stbi_is_16_bit_from_memory(dataOf(bytes), static_cast<int>(bytes.size())) != 0;
}

template <class Value>
std::optional<std::vector<Value>> stbDecode(std::string_view bytes, glm::ivec2 size, int channels) {
  // Four channels of 16 bits per pixel, with the size rounded up to whole blocks, or twice the file size if
  // that is larger.
  const std::size_t blocks =
      (static_cast<std::size_t>(size.x) + 64) * (static_cast<std::size_t>(size.y) + 64);
  maxBytes = std::max(8 * blocks, 2 * bytes.size()) + forHeaders;
  askedForMore = false;
  const auto load = [] {
    if constexpr (std::is_same_v<Value, std::uint8_t>)
      return &stbi_load_from_memory;
    else
      return &stbi_load_16_from_memory;
  }();
  int width = 0, height = 0, inFile = 0;
  const std::unique_ptr<Value, decltype(&stbi_image_free)> values(
      load(dataOf(bytes), static_cast<int>(bytes.size()), &width, &height, &inFile, channels),
      &stbi_image_free);
  if (!values) return std::nullopt;
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                            static_cast<std::size_t>(channels);
  return std::vector<Value>(values.get(), values.get() + count);
}

template std::optional<std::vector<std::uint8_t>> stbDecode(std::string_view, glm::ivec2, int);
template std::optional<std::vector<std::uint16_t>> stbDecode(std::string_view, glm::ivec2, int);

std::string stbReason() {
  return stbi_failure_reason();
}

bool stbFoundMore() {
  return askedForMore;
}

}  // namespace simreel::sim
