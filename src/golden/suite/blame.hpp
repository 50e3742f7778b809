#pragma once
#include "golden/result.hpp"

namespace simreel::golden {

/// Returns the file and line that caused a result: the scene's mistake, else the failing check, else the
/// object whose state or picture differs first, else the scene's "test" member. Returns a line of the
/// sidecar if the sidecar contains the check or the "test" member.
[[nodiscard]] Place blameOf(const SceneResult& scene);

}  // namespace simreel::golden
