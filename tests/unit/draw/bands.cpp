// Tests the number of rows that the exact rasterizer draws at a time.
#include "draw/exact/scene/exact_scene.hpp"

#include <doctest/doctest.h>

namespace simreel::test::draw_bands {

TEST_CASE("exact: a band has as many whole rows of tiles as its memory for visibility and glows allows") {
  constexpr std::size_t visible = std::size_t{32}
                                  << 20;  // number of samples whose visibility fits into 256 MiB
  constexpr std::int64_t software = std::int64_t{128} << 20;  // max size of one buffer on llvmpipe
  CHECK(draw::rowsOfBands({1920, 1080}, 4, {visible, software}) == 1080);
  // Glows need 24 bytes per pixel, so 1456 rows of 3840 pixels fit, although the visibility buffer has room
  // for all 2160.
  CHECK(draw::rowsOfBands({3840, 2160}, 4, {visible, software}) == 1456);
  CHECK(draw::rowsOfBands({3840, 2160}, 4, {visible, std::int64_t{1} << 30}) == 2160);
  CHECK(draw::rowsOfBands({3840, 2160}, 16, {visible, software}) == 544);
  CHECK(draw::rowsOfBands({16384, 16384}, 16, {1, 1}) == 8);
}

}  // namespace simreel::test::draw_bands
