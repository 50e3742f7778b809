#pragma once

/// Elementary functions with the same bits on every machine, where the C library's differ by its version
/// and by the processor. Only operations that IEEE 754 pins down: + - * / and floor of doubles (built with
/// -ffp-contract=off). Results whose magnitude is below 2^-1021 come out as 0. Nothing here knows of NaN.
namespace simreel::ieee {

/// Relative error below 2^-52; infinite above 709, 0 below -708.
[[nodiscard]] double exp(double x);
/// Relative error below 2^-52, whole numbers exactly; infinite from 1023.5 on, 0 below -1021.
[[nodiscard]] double exp2(double x);
/// Of x >= 2^-1022: relative error below 2^-52. Of 0: minus infinity.
[[nodiscard]] double log(double x);
/// Of x >= 2^-1022: relative error below 2^-52, powers of two exactly. Of 0: minus infinity.
[[nodiscard]] double log2(double x);
/// x^y for x >= 0: relative error below 2^-51 for |y| <= 100. Of 0: 0, 1 or infinite.
[[nodiscard]] double pow(double x, double y);

/// For |x| <= 1e6 (an invariant): relative error below 2^-52, next to zeros other than 0 an error below
/// 1e-25.
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
/// The same with 2^-51; sin / cos.
[[nodiscard]] double tan(double x);

/// The angle of (x, y) from the x axis, -pi to pi: an error below 2^-50 of pi. Of (0, 0): 0.
[[nodiscard]] double atan2(double y, double x);

}  // namespace simreel::ieee
