#pragma once
#include <cstdint>

namespace simreel::golden {

// Colour spaces of FLIP. White is D65, that is linear RGB (1, 1, 1).

/// Opponent space: Y is 0 to 116, without the paper's offset of -16; Cx is red-green, Cz blue-yellow.
struct Ycxcz {
  float y, cx, cz;
};
struct LinearRgb {
  float r, g, b;
};
/// L* (0 to 100), and a* and b* times 0.01 L* (Hunt: colours fade in the dark).
struct HuntLab {
  float l, a, b;
};

/// sRGB byte -> linear, 0 to 1 (IEC 61966-2-1).
[[nodiscard]] float linear(std::uint8_t value);
[[nodiscard]] Ycxcz toYcxcz(float r, float g, float b);
/// Back, clamped to 0 to 1.
[[nodiscard]] LinearRgb clampedLinearRgb(const Ycxcz& colour);
[[nodiscard]] HuntLab toHuntLab(const LinearRgb& colour);
/// HyAB distance to the power of 0.7, redistributed to 0 to 1 (section 4.1.4 of the paper).
[[nodiscard]] float colourError(const HuntLab& a, const HuntLab& b);

}  // namespace simreel::golden
