#pragma once
#include "frame/image.hpp"

#include <cstdint>
#include <vector>

namespace simreel::golden {

/// Where pictures of equal size differ: dim grey where they do not; from blue (1/255, still bright) over
/// green and yellow to red (255/255), by the logarithm of the largest channel's difference. Opaque.
[[nodiscard]] frame::Image differenceImage(const frame::Image& a, const frame::Image& b);
/// The same where each pixel's difference is known: of deeper pictures, rounded up.
[[nodiscard]] frame::Image differenceImage(const frame::Image& a, const std::vector<std::uint8_t>& apart);

}  // namespace simreel::golden
