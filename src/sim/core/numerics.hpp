#pragma once
#include <string>

namespace simreel::scene {
struct Scene;
}

namespace simreel::sim {

/// Arithmetic behaviour of the current OpenGL context.
struct Numerics {
  bool exactHolds = false;   ///< True if the GPU computes glsl/common/exact.glsl with the same bits as the
                             ///< C++ build of that file.
  std::string firstFailure;  ///< First mismatch, such as "exactSin(1.5): GPU ..., CPU ..."; empty if
                             ///< exactHolds is true.
  /// Hash of the results of GLSL built-in functions and of the GPU memory path, which determines the
  /// summation order of light. Drivers with equal rounding have equal fingerprints. Pixels are compared
  /// exactly only if the fingerprints are equal.
  std::string fingerprint;
};
[[nodiscard]] Numerics probeNumerics();
/// Throws UserError(device) if the scene requires exact numerics and the device does not provide them.
void requireExact(const scene::Scene& scene, const Numerics& numerics);

/// Runs a shader loop of loopProbeRounds iterations and returns the number of iterations that it really
/// executed.
[[nodiscard]] unsigned probeLoop();
inline constexpr unsigned loopProbeRounds = 70001;

}  // namespace simreel::sim
