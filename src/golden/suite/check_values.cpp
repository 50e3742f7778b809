#include "golden/suite/check_values.hpp"

#include "base/error.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace simreel::golden {

namespace {

double valueOf(const glm::vec4& item, Component component) {
  if (component != Component::length) return item[static_cast<int>(component)];
  const double x = item.x;
  const double y = item.y;
  const double z = item.z;
  return std::sqrt(x * x + y * y + z * z);
}

/// Returns the luma of a pixel's three bytes, 0 to 1, with Rec. 709 weights on sRGB encoded values.
double luma(const std::uint8_t* rgb) {
  return (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / 255.0;
}

}  // namespace

std::optional<Component> componentOf(std::string_view word) {
  if (word == "length") return Component::length;
  const std::size_t index = std::string_view("xyzw").find(word);
  if (word.size() != 1 || index == std::string_view::npos) return std::nullopt;
  return static_cast<Component>(index);
}

double statistic(Statistic which, Component component, std::span<const glm::vec4> items) {
  double sum = 0;
  double min = std::numeric_limits<double>::infinity();
  double max = -min;
  for (const glm::vec4& item : items) {
    const double value = valueOf(item, component);
    sum += value;
    if (std::isnan(value))
      return value;  // A NaN would be ignored, because all comparisons below are
                     // false.
    if (value < min) min = value;
    if (value > max) max = value;
  }
  if (which == Statistic::sum) return sum;
  if (items.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (which == Statistic::mean) return sum / static_cast<double>(items.size());
  return which == Statistic::min ? min : max;
}

NotFinite findNotFinite(std::span<const glm::vec4> items) {
  constexpr std::uint32_t exponent = 0x7f800000;
  NotFinite found;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (int c = 0; c < 4; ++c) {
      if ((std::bit_cast<std::uint32_t>(items[i][c]) & exponent) != exponent) continue;
      if (found.count++ > 0) continue;
      found.element = i;
      found.component = c;
    }
  return found;
}

Contrast contrastOf(const frame::Image& image) {
  SIMREEL_CHECK_EQ(image.bytes.size(),
                   static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
  Contrast contrast;
  if (image.bytes.empty()) return contrast;
  const std::uint8_t* first = image.bytes.data();
  const double pixels = static_cast<double>(image.width) * image.height;
  double sum = 0;
  for (std::size_t i = 0; i < image.bytes.size(); i += 4) {
    const std::uint8_t* pixel = first + i;
    if (pixel[0] != first[0] || pixel[1] != first[1] || pixel[2] != first[2]) contrast.oneColour = false;
    sum += luma(pixel);
  }
  // Uses two passes, because subtracting large sums would lose a small deviation.
  const double mean = sum / pixels;
  double squares = 0;
  for (std::size_t i = 0; i < image.bytes.size(); i += 4) {
    const double difference = luma(first + i) - mean;
    squares += difference * difference;
  }
  contrast.lumaDeviation = std::sqrt(squares / pixels);
  return contrast;
}

}  // namespace simreel::golden
