// Tests that images with data keep 16 bits, and that BMP is read like PNG.
#include "base/error.hpp"
#include "base/file.hpp"
#include "frame/image.hpp"
#include "sim/grid/picture_file.hpp"
#include "unit/help.hpp"

#include <string>
#include <vector>

#include <doctest/doctest.h>

namespace simreel::test::polygons_pictures {

namespace {

/// Returns little-endian words of 1, 2 and 4 bytes.
std::string bytesOf(std::initializer_list<std::pair<int, int>> words) {
  std::string bytes;
  for (const auto& [value, size] : words)
    for (int k = 0; k < size; ++k) bytes += static_cast<char>(value >> 8 * k);
  return bytes;
}

/// Returns a BMP with two pixels, red above blue. If `rows` is negative, the rows are stored from top to
/// bottom.
std::string bmp(int rows) {
  const std::string blue("\xff\0\0\0", 4), red("\0\0\xff\0", 4);
  return "BM" +
         bytesOf({{62, 4},
                  {0, 4},
                  {54, 4},
                  {40, 4},
                  {1, 4},
                  {rows, 4},
                  {1, 2},
                  {24, 2},
                  {0, 4},
                  {8, 4},
                  {0, 4},
                  {0, 4},
                  {0, 4},
                  {0, 4}}) +
         (rows < 0 ? red + blue : blue + red);
}

}  // namespace

TEST_CASE("BMP pictures are read bottom-up and top-down") {
  for (const int rows : {2, -2}) {
    const sim::Picture picture = sim::decodePicture(bmp(rows), "a.bmp", "texture", 64);
    CHECK(picture.size == glm::ivec2(1, 2));
    CHECK(picture.rgba == std::vector<std::uint8_t>{255, 0, 0, 255, 0, 0, 255, 255});
  }
  CHECK_THROWS_AS(static_cast<void>(sim::decodePicture(bmp(-2147483647 - 1), "a.bmp", "texture", 64)),
                  UserError);
  CHECK_THROWS_WITH_AS(static_cast<void>(sim::decodePicture(bmp(60), "a.bmp", "texture", 64)),
                       doctest::Contains("is not a picture"), UserError);
}

TEST_CASE("16-bit PNG values are kept as levels, and 8-bit levels are the picture's luma") {
  const auto levelsOf = [](int bits, const std::vector<std::uint8_t>& bytes) {
    const std::vector<std::byte> png = frame::encodePng({{2, 1}, 3, bits, bytes}, {});
    const TemporaryFile file("levels.png",
                             std::string(reinterpret_cast<const char*>(png.data()), png.size()));
    return sim::loadLevels(file.path(), "terrain", 64);
  };
  const sim::Levels deep = levelsOf(16, {0x12, 0x34, 0x12, 0x34, 0x12, 0x34, 255, 255, 255, 255, 255, 255});
  CHECK(deep.white == 65535);
  CHECK(deep.values == std::vector<std::uint16_t>{0x1234, 65535});
  CHECK(sim::sharesOnGrid(deep, {2, 1}) == std::vector<double>{0x1234 / 65535.0, 1});
  const sim::Levels plain = levelsOf(8, {7, 7, 7, 255, 0, 0});
  CHECK(plain.white == 255);
  CHECK(plain.values == std::vector<std::uint16_t>{7, 53});
}

}  // namespace simreel::test::polygons_pictures
