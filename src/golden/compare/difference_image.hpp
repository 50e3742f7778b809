#pragma once
#include "frame/image.hpp"

namespace simreel::golden {

/// Where pictures of equal size differ: dim grey where they do not; from blue (1/255, still bright) over
/// green and yellow to red (255/255), by the logarithm of the largest channel's difference. Opaque.
[[nodiscard]] frame::Image differenceImage(const frame::Image& a, const frame::Image& b);

}  // namespace simreel::golden
