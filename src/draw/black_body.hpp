#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

/// Linear sRGB of what a black body of that temperature (K, 1667 to 25000) sends, with the luminance 1: by
/// the cubic fit of its place in the CIE 1931 diagram by Kim et al. (J. Korean Phys. Soc. 41, 2002, 865).
/// What lies outside of sRGB, below 1900 K, is cut.
[[nodiscard]] glm::vec3 blackBodyColor(double kelvin);

/// What light that looks white beside a black body of that temperature is shown as beside the white of
/// sRGB: linear sRGB to linear sRGB, by cones as sharpened by Bradford (CIE 159:2004).
[[nodiscard]] glm::mat3 whiteBalance(double kelvin);

}  // namespace simreel::draw
