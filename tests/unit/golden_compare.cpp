#include "golden/compare.hpp"

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("pictures are compared by channel and by share of pixels") {
  frame::Image a{3, 2, std::vector<std::uint8_t>(24, 100)};
  frame::Image b = a;
  b.bytes[4] = 103;
  b.bytes[9] = 80;
  b.bytes[15] = 0;  // alpha does not count
  const golden::Tolerance tight{2, 0.0};
  const auto result = golden::compareImages(a, b, tight);
  CHECK(result.mostDifferent == 20);
  CHECK(result.differentPixels == 2);
  CHECK(result.pixelsBeyond == 2);
  CHECK_FALSE(golden::within(result, a, tight));
  const golden::Tolerance loose{3, 0.17};
  CHECK(golden::within(golden::compareImages(a, b, loose), a, loose));
  CHECK(golden::within(golden::compareImages(a, a, tight), a, tight));
}
