#pragma once
#include "sim/light/light_file.hpp"

#include <filesystem>
#include <string>

namespace simreel::sim {

/// What messages call the picture of a sky.
[[nodiscard]] std::string surroundingsLabel(const std::filesystem::path& file);

/// The picture of a sky, Radiance or OpenEXR. Throws UserError: inputOutput for what is neither or damaged,
/// what readFile says for a file that cannot be read.
[[nodiscard]] LightFile readSurroundings(const std::filesystem::path& file);

/// Throws UserError(inputOutput) with `label` first for a picture that is not twice as wide as high, is a
/// cube map, lacks a channel, has other primaries than Rec. 709, or holds what is no light. Values above
/// -0.001 are let through with one warning; they count as 0.
void checkSurroundings(const LightFile& picture, const std::string& label);

}  // namespace simreel::sim
