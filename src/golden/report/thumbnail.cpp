#include "golden/report/thumbnail.hpp"

#include "base/error.hpp"
#include "golden/files/picture.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <span>

namespace simreel::golden {

namespace {

std::string base64(std::span<const std::byte> bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8U | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[bits >> (18U - 6U * k) & 63U];
  }
  return text;
}

}  // namespace

frame::Image thumbnail(const frame::Image& image, int side) {
  const int block = (std::max(image.width, image.height) + side - 1) / side;
  if (block <= 1) return image;
  frame::Image small{(image.width + block - 1) / block, (image.height + block - 1) / block, {}};
  small.bytes.reserve(4 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      std::uint32_t sum[4] = {}, count = 0;
      for (int v = y * block; v < std::min((y + 1) * block, image.height); ++v)
        for (int u = x * block; u < std::min((x + 1) * block, image.width); ++u, ++count)
          for (std::size_t c = 0; c < 4; ++c)
            sum[c] += image.bytes[4 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
                                       static_cast<std::size_t>(u)) +
                                  c];
      for (const std::uint32_t channel : sum)
        small.bytes.push_back(static_cast<std::uint8_t>((channel + count / 2) / count));
    }
  return small;
}

std::string dataAddress(const std::filesystem::path& picture, int side) {
  try {
    const auto png = frame::encodePng(thumbnail(readPicture(picture, "picture").image, side), {});
    return "data:image/png;base64," + base64(png);
  } catch (const UserError&) {
    return {};
  }
}

std::string addressOf(const std::string& path) {
  std::string address;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || std::string_view("-._~/").find(c) != std::string_view::npos)
      address += c;
    else
      address += fmt::format("%{:02X}", byte);
  }
  return address;
}

}  // namespace simreel::golden
