#include "frame/png_text.hpp"

#include <string>
#include <string_view>

#include <isa-l/crc.h>

namespace simreel::frame {

namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t aroundChunk = 12;  ///< length, kind, checksum

std::size_t wordAt(std::string_view bytes, std::size_t at) {
  std::size_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8U | static_cast<unsigned char>(bytes[at + i]);
  return word;
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
  const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());
  ImageText texts;
  if (!bytes.starts_with(signature)) return texts;
  for (std::size_t at = signature.size(); at + aroundChunk <= bytes.size();) {
    const std::size_t length = wordAt(bytes, at);
    if (length > bytes.size() - at - aroundChunk) break;
    const std::string_view kind = bytes.substr(at + 4, 4), body = bytes.substr(at + 8, length);
    if (kind == "IEND") break;
    const std::size_t end = body.find('\0');
    if (end != std::string_view::npos && kind == "tEXt")
      texts.emplace_back(body.substr(0, end), fromLatin1(body.substr(end + 1)));
    // Not compressed, without language and translated keyword: as we write it.
    constexpr std::string_view plain("\0\0\0\0\0", 5);
    if (end != std::string_view::npos && kind == "iTXt" && body.substr(end).starts_with(plain))
      texts.emplace_back(body.substr(0, end), body.substr(end + plain.size()));
    at += length + aroundChunk;
  }
  return texts;
}

bool isWholePng(std::span<const std::byte> png) {
  const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());
  if (!bytes.starts_with(signature)) return false;
  for (std::size_t at = signature.size(); at + aroundChunk <= bytes.size();) {
    const std::size_t length = wordAt(bytes, at);
    if (length > bytes.size() - at - aroundChunk) return false;
    const auto* covered = reinterpret_cast<const unsigned char*>(bytes.data() + at + 4);
    if (crc32_gzip_refl(0, covered, length + 4) != wordAt(bytes, at + 8 + length)) return false;
    if (bytes.substr(at + 4, 4) == "IEND") return true;
    at += length + aroundChunk;
  }
  return false;
}

}  // namespace simreel::frame
