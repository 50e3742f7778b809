#include "frame/png_text.hpp"

#include "base/png.hpp"

#include <string>
#include <string_view>

namespace simreel::frame {

namespace {

std::optional<std::string_view> chunksOf(std::span<const std::byte> png) {
  return pngChunks({reinterpret_cast<const char*>(png.data()), png.size()});
}

std::string fromLatin1(std::string_view text) {
  std::string utf8;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80)
      utf8 += c;
    else
      utf8 += {static_cast<char>(0xC0U | byte >> 6U), static_cast<char>(0x80U | (byte & 0x3FU))};
  }
  return utf8;
}

}  // namespace

ImageText readPngText(std::span<const std::byte> png) {
  ImageText texts;
  auto rest = chunksOf(png);
  if (!rest) return texts;
  while (const auto chunk = takePngChunk(*rest)) {
    const std::string_view body = chunk->data;
    if (chunk->type == "IEND") break;
    const std::size_t end = body.find('\0');
    if (end != std::string_view::npos && chunk->type == "tEXt")
      texts.emplace_back(body.substr(0, end), fromLatin1(body.substr(end + 1)));
    // simreel writes only this form of iTXt: uncompressed, empty language, empty translated keyword.
    constexpr std::string_view plain("\0\0\0\0\0", 5);
    if (end != std::string_view::npos && chunk->type == "iTXt" && body.substr(end).starts_with(plain))
      texts.emplace_back(body.substr(0, end), body.substr(end + plain.size()));
  }
  return texts;
}

bool isWholePng(std::span<const std::byte> png) {
  auto rest = chunksOf(png);
  if (!rest) return false;
  while (const auto chunk = takePngChunk(*rest)) {
    if (!chunk->checksumHolds()) return false;
    if (chunk->type == "IEND") return true;
  }
  return false;
}

}  // namespace simreel::frame
