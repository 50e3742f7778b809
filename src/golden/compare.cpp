#include "golden/compare.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cstdlib>

namespace simreel::golden {

Comparison compareImages(const frame::Image& a, const frame::Image& b, const Tolerance& tolerance) {
  SIMREEL_CHECK_EQ(a.width, b.width);
  SIMREEL_CHECK_EQ(a.height, b.height);
  Comparison result;
  for (std::size_t pixel = 0; pixel < a.bytes.size(); pixel += 4) {
    int apart = 0;
    for (std::size_t c = 0; c < 3; ++c)
      apart = std::max(apart, std::abs(int{a.bytes[pixel + c]} - b.bytes[pixel + c]));
    result.mostDifferent = std::max(result.mostDifferent, apart);
    result.differentPixels += apart > 0 ? 1 : 0;
    result.pixelsBeyond += apart > tolerance.channel ? 1 : 0;
  }
  return result;
}

bool within(const Comparison& comparison, const frame::Image& image, const Tolerance& tolerance) {
  return comparison.pixelsBeyond <= tolerance.pixels * image.width * image.height;
}

}  // namespace simreel::golden
