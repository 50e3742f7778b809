#pragma once
#include <string>

namespace simreel::kernels {

/// Returns true if a ShaderToy text calls dFdx, dFdy or fwidth.
[[nodiscard]] bool usesDerivatives(const std::string& text);

/// Returns the functions dFdx, dFdy and fwidth for a ShaderToy pass that runs as a compute shader.
/// mainImage() runs three times for each pixel: for its neighbour in x and its neighbour in y within the
/// same 2x2 pixels, then for the pixel itself. The n-th call of a derivative function returns the
/// difference between the arguments of the n-th calls of the runs. Calls after the 64th return 0, and so do
/// calls that the neighbour does not make.
[[nodiscard]] std::string derivativeFunctions();

/// Returns the statements that run mainImage() three times. Global variables that the text assigns to are
/// reset to their initial values before each run.
[[nodiscard]] std::string threeRuns(const std::string& text);

}  // namespace simreel::kernels
