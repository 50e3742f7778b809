#pragma once
#include <string>

namespace simreel::scene {
struct Scene;
}

namespace simreel::sim {

/// Arithmetic behaviour of the current OpenGL context.
struct Numerics {
  bool exactHolds = false;  ///< True if glsl/common/exact.glsl gives the same bits as its C++ twin.
  std::string
      firstFailure;  ///< First mismatch, such as "exactSin(1.5): GPU ..., CPU ..."; empty if exactHolds.
  /// Hash of the results of GLSL built-in functions and of the memory path, which determines the summation
  /// order of light. Drivers that round alike have equal fingerprints. Pixels are compared exactly only
  /// between equal fingerprints.
  std::string fingerprint;
};
[[nodiscard]] Numerics probeNumerics();
/// Throws UserError(device) if the scene requires exact numerics and the device does not provide them.
void requireExact(const scene::Scene& scene, const Numerics& numerics);

/// Returns the number of iterations that a shader loop of 70,001 iterations actually executes.
[[nodiscard]] unsigned probeLoop();
inline constexpr unsigned loopProbeRounds = 70001;

}  // namespace simreel::sim
