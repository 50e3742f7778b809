#pragma once
#include "frame/image.hpp"

#include <cstdint>
#include <vector>

namespace simreel::golden {

/// Returns an opaque false-colour image of the differences between pictures of equal size. Equal pixels are
/// dim grey. Other pixels range from bright blue (difference 1/255) through green and yellow to red
/// (255/255), by the logarithm of the largest channel difference.
[[nodiscard]] frame::Image differenceImage(const frame::Image& a, const frame::Image& b);
/// Returns the difference image for known differences of each pixel, rounded up. It is used for pictures
/// with more than 8 bits per channel.
[[nodiscard]] frame::Image differenceImage(const frame::Image& a,
                                           const std::vector<std::uint8_t>& difference);

}  // namespace simreel::golden
