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

/// Throws UserError(inputOutput), which begins with `label`, for a picture that cannot be a sky: not twice
/// as wide as high, a cube map, a missing channel, primaries other than Rec. 709, or values that are no
/// light. Values from -0.001 to 0 count as 0, with one warning.
void checkSurroundings(const LightFile& picture, const std::string& label);

}  // namespace simreel::sim
