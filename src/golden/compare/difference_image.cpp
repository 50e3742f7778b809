#include "golden/compare/difference_image.hpp"

#include "base/error.hpp"
#include "golden/compare/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace simreel::golden {

namespace {

using Colour = std::array<std::uint8_t, 3>;

/// Returns the colour of each difference from 0 to 255. Entry 0 is unused.
std::array<Colour, 256> heatColours() {
  constexpr std::array<std::array<double, 3>, 4> stops = {
      {{70, 120, 255}, {0, 210, 140}, {255, 220, 0}, {255, 30, 20}}};
  std::array<Colour, 256> colours{};
  for (std::size_t difference = 1; difference < colours.size(); ++difference) {
    const double at = std::log(double(difference)) / std::log(255.0) * (stops.size() - 1);
    const std::size_t stop = std::min(stops.size() - 2, static_cast<std::size_t>(at));
    const double t = at - double(stop);
    for (std::size_t c = 0; c < 3; ++c)
      colours[difference][c] =
          static_cast<std::uint8_t>(std::lround(stops[stop][c] * (1 - t) + stops[stop + 1][c] * t));
  }
  return colours;
}

/// Returns a quarter of the luma, so that the picture stays recognisable and grey is never close to a heat
/// colour.
std::uint8_t dimmed(const std::uint8_t* pixel) {
  return static_cast<std::uint8_t>((54 * pixel[0] + 183 * pixel[1] + 19 * pixel[2]) / 1024 + 8);
}

}  // namespace

frame::Image differenceImage(const frame::Image& a, const frame::Image& b) {
  SIMREEL_CHECK_EQ(a.width, b.width);
  SIMREEL_CHECK_EQ(a.height, b.height);
  std::vector<std::uint8_t> difference(a.bytes.size() / 4);
  for (std::size_t pixel = 0; pixel < difference.size(); ++pixel)
    for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i)
      difference[pixel] = std::max(difference[pixel],
                                   static_cast<std::uint8_t>(std::abs(int{a.bytes[i]} - int{b.bytes[i]})));
  return differenceImage(a, difference);
}

frame::Image differenceImage(const frame::Image& a, const std::vector<std::uint8_t>& difference) {
  SIMREEL_CHECK_EQ(a.bytes.size(), 4 * difference.size());
  static const std::array<Colour, 256> heat = heatColours();
  frame::Image result{a.width, a.height, std::vector<std::uint8_t>(a.bytes.size(), 255)};
  for (std::size_t pixel = 0; pixel < difference.size(); ++pixel) {
    std::uint8_t* const to = result.bytes.data() + 4 * pixel;
    if (difference[pixel] == 0)
      std::fill(to, to + 3, dimmed(a.bytes.data() + 4 * pixel));
    else
      std::copy(heat[difference[pixel]].begin(), heat[difference[pixel]].end(), to);
  }
  return result;
}

}  // namespace simreel::golden
