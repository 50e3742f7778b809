#pragma once

/// Elementary functions that return the same bits on every machine. Results of the C library, in contrast,
/// depend on its version and on the processor. The functions use only operations that IEEE 754 defines
/// exactly: + - * /, square root and floor of doubles (compiled with -ffp-contract=off). Results with a
/// magnitude below 2^-1021 become 0. NaN is not supported.
namespace simreel::ieee {

/// Returns e^x with a relative error below 2^-52. The result is infinity above 709 and 0 below -708.
[[nodiscard]] double exp(double x);
/// Returns 2^x with a relative error below 2^-52, and exactly for whole numbers. The result is infinity
/// from 1023.5 on and 0 below -1021.
[[nodiscard]] double exp2(double x);
/// Returns the natural logarithm of x >= 2^-1022, with a relative error below 2^-52. log(0) is minus
/// infinity.
[[nodiscard]] double log(double x);
/// Returns the binary logarithm of x >= 2^-1022 with a relative error below 2^-52. The result is exact for
/// powers of two. log2(0) is minus infinity.
[[nodiscard]] double log2(double x);
/// Returns x^y for x >= 0 with a relative error below 2^-51 for |y| <= 100. pow(0, y) is 0, 1 or infinity.
[[nodiscard]] double pow(double x, double y);

/// Returns the sine for |x| <= 1e6 (checked) with a relative error below 2^-52. Near a zero other than x =
/// 0, the absolute error is below 1e-25. The same holds for cos().
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
/// Returns sin(x) / cos(x) for |x| <= 1e6, with a relative error below 2^-51.
[[nodiscard]] double tan(double x);

/// Returns the angle between the x axis and the vector (x, y), from -pi to pi, with an error below 2^-50
/// pi. atan2(0, 0) is 0.
[[nodiscard]] double atan2(double y, double x);

}  // namespace simreel::ieee
