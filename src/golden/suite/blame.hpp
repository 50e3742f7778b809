#pragma once
#include "golden/result.hpp"

namespace simreel::golden {

/// The line that a result is about: where the scene's mistake is, the check that fails, the object whose
/// state or picture differs first, else what the scene says of its test. In the sidecar where that says it.
[[nodiscard]] Place blameOf(const SceneResult& scene);

}  // namespace simreel::golden
