#pragma once
#include "golden/result.hpp"

namespace simreel::golden {

/// Returns the file and line that caused a result. This is the scene's mistake if there is one, otherwise
/// the failing check, otherwise the object whose state or picture differs first, and otherwise the scene's
/// "test" member. Returns a line of the sidecar if the sidecar contains the check or the "test" member.
[[nodiscard]] Place blameOf(const SceneResult& scene);

}  // namespace simreel::golden
