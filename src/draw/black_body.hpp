#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

/// Returns the linear sRGB colour of a black body at `kelvin` (1667 to 25000 K), scaled to luminance 1.
/// Computes it from the cubic fit of the CIE 1931 chromaticity by Kim et al. (J. Korean Phys. Soc. 41,
/// 2002, 865). Below 1900 K the colour is outside sRGB and is clamped.
[[nodiscard]] glm::vec3 blackBodyColor(double kelvin);

/// Returns the white balance matrix for linear sRGB. It adapts light whose white point is a black body at
/// `kelvin` to the white point of sRGB, in Bradford's sharpened cone space (CIE 159:2004).
[[nodiscard]] glm::mat3 whiteBalance(double kelvin);

}  // namespace simreel::draw
