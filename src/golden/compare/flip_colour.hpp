#pragma once
#include <cstddef>
#include <cstdint>

namespace simreel::golden {

// Colour spaces of FLIP, of `count` pixels at a time, a row of floats for each coordinate; rows have room
// up to the next multiple of 4. White is D65, that is linear RGB (1, 1, 1).

struct ThreeRows {
  float *first, *second, *third;
};
struct ThreeConstRows {
  const float *first, *second, *third;
  ThreeConstRows(const float* a, const float* b, const float* c) : first(a), second(b), third(c) {}
  ThreeConstRows(const ThreeRows& rows) : ThreeConstRows(rows.first, rows.second, rows.third) {}
};

/// sRGB -> linear, 0 to 1 (IEC 61966-2-1), of the pixels at those bytes of `rgba`.
void toLinear(const std::uint8_t* rgba, const std::ptrdiff_t* offsets, int count, const ThreeRows& rgb);
/// Linear RGB -> opponent space: Y is 0 to 116, without the paper's offset of -16; Cx is red-green, Cz
/// blue-yellow.
void toYcxcz(const ThreeConstRows& rgb, int count, const ThreeRows& ycxcz);
/// Back, clamped to the cube of RGB, and on to L* (0 to 100), and a* and b* times 0.01 L* (Hunt: colours
/// fade in the dark).
void toHuntLab(const ThreeConstRows& ycxcz, int count, const ThreeRows& lab);
/// HyAB distance to the power of 0.7, redistributed to 0 to 1 (section 4.1.4 of the paper). Exactly 0 for
/// equal colours.
void colourErrors(const ThreeConstRows& a, const ThreeConstRows& b, int count, float* errors);

}  // namespace simreel::golden
