#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace simreel::frame {

/// Decodes the kind of PNG that nearly all files are - RGB or RGBA of 8 bits, not interlaced, no
/// transparent colour - in a third of stb_image's time (ISA-L inflates). Nothing for any other file, and
/// for one with anything wrong or with a side above `maxSide`: it is left to the decoder that says what is
/// wrong.
[[nodiscard]] std::optional<Image> decodePlainPng(std::span<const std::byte> file, int maxSide);

}  // namespace simreel::frame
