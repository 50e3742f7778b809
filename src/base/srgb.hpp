#pragma once
/// Transfer function of sRGB (IEC 61966-2-1), which returns the same bits on every machine.

namespace simreel {

/// Returns the linear value (0 to 1) of an sRGB value from 0 to 1.
[[nodiscard]] double linearOfSrgb(double encoded);
/// Returns the sRGB value of a linear value from 0 to 1. Values above 1 continue the curve.
[[nodiscard]] double srgbOfLinear(double linear);

}  // namespace simreel
