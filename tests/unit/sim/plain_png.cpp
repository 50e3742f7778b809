// Tests the fast decoder of plain PNG files by comparison with the original images. Also tests files that
// it must leave to the general decoder.
#include "sim/grid/plain_png.hpp"

#include "unit/frame/help.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <isa-l/crc.h>

using namespace simreel;

namespace {

constexpr int maxSide = 4096;

std::string number(std::uint32_t value) {
  std::string text;
  for (const int shift : {24, 16, 8, 0}) text += static_cast<char>(value >> shift & 0xff);
  return text;
}

std::string chunk(std::string_view type, const std::string& data) {
  const std::string body = std::string(type) + data;
  const auto* bytes = reinterpret_cast<const unsigned char*>(body.data());
  return number(std::uint32_t(data.size())) + body + number(crc32_gzip_refl(0, bytes, body.size()));
}

/// Returns a zlib stream that consists of stored (uncompressed) blocks (RFC 1950, 1951).
std::string stored(const std::string& bytes) {
  std::string text("\x78\x01\x01", 3);
  const auto size = static_cast<unsigned>(bytes.size());
  for (const unsigned value : {size & 0xff, size >> 8, ~size & 0xff, ~size >> 8 & 0xff})
    text += static_cast<char>(value);
  std::uint32_t low = 1, high = 0;
  for (const char byte : bytes) {
    low = (low + static_cast<unsigned char>(byte)) % 65521;
    high = (high + low) % 65521;
  }
  return text + bytes + number(high << 16 | low);
}

struct Png {
  int width = 5, height = 6;
  char colour = 2, depth = 8, interlaced = 0;
  std::string rows, between;
  std::size_t chunkSize = 1000;

  [[nodiscard]] std::string file() const {
    std::string header = number(std::uint32_t(width)) + number(std::uint32_t(height));
    header += {depth, colour, 0, 0, interlaced};
    std::string text = "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + between;
    const std::string pixels = stored(rows);
    for (std::size_t at = 0; at < pixels.size(); at += chunkSize)
      text += chunk("IDAT", pixels.substr(at, chunkSize));
    return text + chunk("IEND", "");
  }
};

std::optional<sim::Picture> decode(const std::string& file) {
  return sim::decodePlainPng(file, maxSide);
}

/// Filters the rows of an image as in table 9.1 of the PNG specification. Each row uses the next filter
/// type.
Png filtered(const frame::Image& image, int channels) {
  Png png;
  png.width = image.width;
  png.height = image.height;
  png.colour = static_cast<char>(channels == 3 ? 2 : 6);
  const auto at = [&](int x, int y, int c) {
    return x < 0 || y < 0 ? 0 : int{image.bytes[std::size_t(4 * (y * image.width + x) + c)]};
  };
  for (int y = 0; y < image.height; ++y) {
    const int filter = y % 5;
    png.rows += static_cast<char>(filter);
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < channels; ++c) {
        const int a = at(x - 1, y, c), b = at(x, y - 1, c), corner = at(x - 1, y - 1, c);
        const int p = a + b - corner, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - corner);
        const int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : corner;
        const std::array<int, 5> predicted = {0, a, b, (a + b) / 2, paeth};
        png.rows += static_cast<char>(at(x, y, c) - predicted[std::size_t(filter)]);
      }
  }
  return png;
}

}  // namespace

TEST_CASE("plain png: all filters, RGB and RGBA, and any number of chunks are read") {
  for (const int channels : {3, 4}) {
    frame::Image image = frame::test::picture(31, 17);
    for (std::size_t i = 3; i < image.bytes.size(); i += 4)
      image.bytes[i] = channels == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>(7 * i);
    for (const std::size_t size : {std::size_t{1}, std::size_t{7}, std::size_t{100000}}) {
      Png png = filtered(image, channels);
      png.chunkSize = size;
      png.between = chunk("tEXt", "Title");
      const auto decoded = decode(png.file());
      REQUIRE(decoded);
      CHECK(decoded->size.x == 31);
      CHECK(decoded->rgba == image.bytes);
    }
  }
}

TEST_CASE("plain png: files that are not plain or are damaged are left to the general decoder") {
  const Png good = filtered(frame::test::picture(5, 6), 3);
  CHECK(decode(good.file()));
  const auto changed = [&](const auto& change) {
    Png png = good;
    change(png);
    return decode(png.file());
  };
  CHECK_FALSE(changed([](Png& png) { png.colour = 0; }));
  CHECK_FALSE(changed([](Png& png) { png.depth = 16; }));
  CHECK_FALSE(changed([](Png& png) { png.interlaced = 1; }));
  CHECK_FALSE(changed([](Png& png) { png.width = maxSide + 1; }));
  CHECK_FALSE(changed([](Png& png) { png.width = 0; }));
  CHECK_FALSE(changed([](Png& png) { png.height = 7; }));
  CHECK_FALSE(changed([](Png& png) { png.rows += "x"; }));
  CHECK_FALSE(changed([](Png& png) { png.rows[0] = 5; }));
  CHECK_FALSE(changed([](Png& png) { png.between = chunk("tRNS", std::string(6, '\0')); }));
  CHECK_FALSE(changed([](Png& png) { png.between = chunk("CgBI", "abcd"); }));
  const std::string file = good.file();
  for (std::size_t size = 0; size < file.size(); ++size) CHECK_FALSE(decode(file.substr(0, size)));
}
