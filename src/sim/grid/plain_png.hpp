#pragma once
#include "sim/grid/picture_file.hpp"

#include <optional>
#include <string_view>

namespace simreel::sim {

/// Decodes the kind of PNG that nearly all files are - RGB or RGBA of 8 bits, not interlaced, no
/// transparent colour - in a third of stb_image's time (ISA-L inflates). Nothing for any other file, and
/// for one with anything wrong or with a side above `maxSide`: it is left to the decoder that says what is
/// wrong.
[[nodiscard]] std::optional<Picture> decodePlainPng(std::string_view file, int maxSide);

}  // namespace simreel::sim
