#pragma once
#include "sim/light/light_file.hpp"

#include <filesystem>
#include <string>

namespace simreel::sim {

/// Returns the name that messages use for a sky image.
[[nodiscard]] std::string surroundingsLabel(const std::filesystem::path& file);

/// Reads the image of a sky in the format Radiance or OpenEXR. Throws UserError(inputOutput) for another
/// format or damaged content, and the errors of readFile().
[[nodiscard]] LightFile readSurroundings(const std::filesystem::path& file);

/// Throws UserError(inputOutput), with a message that begins with `label`, for an image that cannot be a
/// sky: not twice as wide as high, a cube map, a missing channel, primaries other than Rec. 709, or values
/// that are negative, too large or NaN. Values from -0.001 to 0 count as 0 and cause one warning.
void checkSurroundings(const LightFile& picture, const std::string& label);

}  // namespace simreel::sim
