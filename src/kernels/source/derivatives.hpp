#pragma once
#include <string>

namespace simreel::kernels {

/// Returns true if a ShaderToy text calls dFdx, dFdy or fwidth.
[[nodiscard]] bool usesDerivatives(const std::string& text);

/// Returns the functions dFdx, dFdy and fwidth for a ShaderToy pass that runs as a compute shader.
/// mainImage() runs three times for each pixel: for the pixel's neighbour in x and neighbour in y within
/// the same 2x2 pixels, then for the pixel. The n-th call of a derivative function returns the difference
/// between the arguments of the n-th calls of the runs. Calls after the 64th return 0, as do calls that the
/// run of the neighbour does not make.
[[nodiscard]] std::string derivativeFunctions();

/// Returns the statements that run mainImage() three times. Global variables that the text assigns to are
/// reset to their initial values before each run.
[[nodiscard]] std::string threeRuns(const std::string& text);

}  // namespace simreel::kernels
