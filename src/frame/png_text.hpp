#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <span>

namespace simreel::frame {

/// Returns the uncompressed text chunks of a PNG, in file order, as UTF-8. Returns none if the data is not
/// a PNG; stops at the first incomplete chunk.
[[nodiscard]] ImageText readPngText(std::span<const std::byte> png);

/// True if a PNG has all chunks up to IEND with valid checksums.
[[nodiscard]] bool isWholePng(std::span<const std::byte> png);

}  // namespace simreel::frame
