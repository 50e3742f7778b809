#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <span>

namespace simreel::frame {

/// Text chunks of a PNG that are not compressed, as UTF-8, in their order; none of what is no PNG or ends
/// before its time.
[[nodiscard]] ImageText readPngText(std::span<const std::byte> png);

/// True if a PNG has all its chunks up to the end, with right checksums.
[[nodiscard]] bool isWholePng(std::span<const std::byte> png);

}  // namespace simreel::frame
