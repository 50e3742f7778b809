#include "golden/report/thumbnail.hpp"

#include "unit/frame/help.hpp"

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::golden;

TEST_CASE("thumbnails average whole blocks of pixels") {
  frame::Image image{5, 2, {}};
  for (int i = 0; i < 10; ++i)
    for (int c = 0; c < 4; ++c) image.bytes.push_back(static_cast<std::uint8_t>(20 * i + c));
  CHECK(thumbnail(image, 5).bytes == image.bytes);
  const frame::Image small = thumbnail(image, 3);
  CHECK(small.width == 3);
  CHECK(small.height == 1);
  // The blocks are pixels 0 1 5 6, pixels 2 3 7 8, and pixels 4 9 of the last column.
  CHECK(small.bytes == std::vector<std::uint8_t>{60, 61, 62, 63, 100, 101, 102, 103, 130, 131, 132, 133});
  CHECK(thumbnail(image, 1).width == 1);
  CHECK(thumbnail(image, 1).bytes[0] == 90);
}

TEST_CASE("URLs of pictures are percent-encoded") {
  CHECK(addressOf("files/a-b_c.~/1.png") == "files/a-b_c.~/1.png");
  CHECK(addressOf("r & d/\"<\xC3\xA9%") == "r%20%26%20d/%22%3C%C3%A9%25");
  CHECK(dataAddress("nowhere.png", 160).empty());
}
