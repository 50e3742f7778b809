#pragma once
#include <string>

namespace simreel::scene {
struct Scene;
}

namespace simreel::sim {

/// How the current context computes.
struct Numerics {
  bool exactHolds = false;   ///< glsl/common/exact.glsl gives the bits of its C++ twin
  std::string firstFailure;  ///< "exactSin(1.5): GPU ..., CPU ..." when it does not
  /// Hash of what the built-ins gave, and of the memory path, which adds up light in another order: equal
  /// on drivers that round alike. Pixels are compared exactly only between equal fingerprints.
  std::string fingerprint;
};
[[nodiscard]] Numerics probeNumerics();
/// Throws UserError(device) where the scene wants exact numerics and the device does not compute so.
void requireExact(const scene::Scene& scene, const Numerics& numerics);

/// Iterations a shader loop of 70,001 rounds really makes.
[[nodiscard]] unsigned probeLoop();
inline constexpr unsigned loopProbeRounds = 70001;

}  // namespace simreel::sim
