#pragma once
/// Transfer function of sRGB (IEC 61966-2-1), with the same bits on every machine.

namespace simreel {

/// Returns the linear value of an sRGB fraction, 0 to 1.
[[nodiscard]] double linearOfSrgb(double encoded);
/// Returns the sRGB fraction of a linear value, 0 to 1. Values above 1 continue the curve.
[[nodiscard]] double srgbOfLinear(double linear);

}  // namespace simreel
