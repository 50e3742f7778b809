#pragma once
#include <cstddef>
#include <cstdint>

namespace simreel::golden {

// One row of floats per colour coordinate, padded to a multiple of 4. The functions below are the colour
// space conversions of FLIP and process `count` pixels. White is D65, linear RGB (1, 1, 1).

struct ThreeRows {
  float *first, *second, *third;
};
struct ThreeConstRows {
  const float *first, *second, *third;
  ThreeConstRows(const float* a, const float* b, const float* c) : first(a), second(b), third(c) {}
  ThreeConstRows(const ThreeRows& rows) : ThreeConstRows(rows.first, rows.second, rows.third) {}
};

/// Converts sRGB bytes to linear RGB in 0 to 1 (IEC 61966-2-1). `offsets` are the byte offsets of the
/// pixels in `rgba`.
void toLinear(const std::uint8_t* rgba, const std::ptrdiff_t* offsets, int count, const ThreeRows& rgb);
/// Converts linear RGB to the opponent space YCxCz. Y is 0 to 116, without the paper's offset of -16. Cx is
/// red-green, and Cz is blue-yellow.
void toYcxcz(const ThreeConstRows& rgb, int count, const ThreeRows& ycxcz);
/// Converts YCxCz to RGB, clamps it to the RGB cube, and converts it to L* (0 to 100) and to a* and b*,
/// both multiplied by 0.01 L*. The factor models the Hunt effect: colours look less saturated in the dark.
void toHuntLab(const ThreeConstRows& ycxcz, int count, const ThreeRows& lab);
/// Computes the HyAB distance to the power of 0.7, remapped to 0 to 1 (section 4.1.4 of the paper). The
/// result is exactly 0 for equal colours.
void colourErrors(const ThreeConstRows& a, const ThreeConstRows& b, int count, float* errors);

}  // namespace simreel::golden
