#pragma once
#include <string>

namespace simreel::kernels {

/// True if a ShaderToy text calls dFdx, dFdy or fwidth.
[[nodiscard]] bool usesDerivatives(const std::string& text);

/// Returns the functions dFdx, dFdy and fwidth for an image that a compute shader draws. mainImage() runs
/// three times for each pixel: for its neighbours of the same 2x2 pixels along x and y, then for itself.
/// The n-th derivative is the difference of the n-th arguments, for the first 64; then 0. Differences that
/// the neighbour does not compute are 0, too.
[[nodiscard]] std::string derivativeFunctions();

/// Returns the statements that run mainImage() three times. Global variables that the text assigns to begin
/// each run with their first value.
[[nodiscard]] std::string threeRuns(const std::string& text);

}  // namespace simreel::kernels
