// Fuzzes the strict reader of PNG files for comparisons. An accepted image is decoded and encoded, and the
// result must decode to the same pixels.
#include "golden/files/png_check.hpp"

#include "base/error.hpp"
#include "fuzz/reader.hpp"

#include <cstdint>

#include <isa-l/crc.h>

namespace simreel::fuzz {
namespace {

constexpr std::size_t signature = 8;

std::uint32_t bigEndian(const char* at) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(at[i]);
  return value;
}

/// Updates the checksums of all chunks.
void mendPngCheck(std::string& bytes) {
  for (std::size_t at = signature; at + 12 <= bytes.size();) {
    const std::size_t length = bigEndian(&bytes[at]);
    if (length > bytes.size() - at - 12) return;
    const std::uint32_t sum =
        crc32_gzip_refl(0, reinterpret_cast<const unsigned char*>(&bytes[at + 4]), length + 4);
    for (std::size_t i = 0; i < 4; ++i) bytes[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i));
    at += length + 12;
  }
}

void readPngCheck(std::string_view bytes) {
  const auto file = std::as_bytes(std::span(bytes.data(), bytes.size()));
  golden::checkPng(file, "picture", "fuzz.png");
  SIMREEL_CHECK(golden::sameEncodedPixels(file, file));
  const frame::Image image = frame::decodeImage(file, "fuzz.png");
  if (image.width * image.height > 1 << 16) return;
  const auto again = frame::encodePng(image, {{"Title", "fuzz"}});
  golden::checkPng(again, "picture", "again.png");
  SIMREEL_CHECK_EQ(frame::pixelHash(frame::decodeImage(again, "again.png")), frame::pixelHash(image));
}

const Reader pngCheckReader("png_check", readPngCheck, mendPngCheck);

}  // namespace
}  // namespace simreel::fuzz
