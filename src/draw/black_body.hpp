#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

/// Returns the linear sRGB colour, scaled to luminance 1, of a black body at `kelvin` (1667 to 25000 K),
/// from the cubic fit of its CIE 1931 chromaticity by Kim et al. (J. Korean Phys. Soc. 41, 2002, 865).
/// Colours outside sRGB, below 1900 K, are clamped.
[[nodiscard]] glm::vec3 blackBodyColor(double kelvin);

/// Returns the matrix from linear sRGB to linear sRGB that adapts light with the white point of a black
/// body at `kelvin` to the white of sRGB, in Bradford's sharpened cone space (CIE 159:2004).
[[nodiscard]] glm::mat3 whiteBalance(double kelvin);

}  // namespace simreel::draw
