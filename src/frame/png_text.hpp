#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <span>

namespace simreel::frame {

/// Returns the uncompressed text chunks of a PNG as UTF-8, in file order. Returns none if the data is not a
/// PNG. Stops at the first incomplete chunk.
[[nodiscard]] ImageText readPngText(std::span<const std::byte> png);

/// True if a PNG has all chunks up to IEND with valid checksums.
[[nodiscard]] bool isWholePng(std::span<const std::byte> png);

}  // namespace simreel::frame
