#pragma once
#include "scene/test.hpp"

#include <map>
#include <string>

namespace simreel::golden {

/// Sets the bound named `field`, which must be a name from tolerance.bounds().
void setBound(scene::Tolerance& tolerance, const std::string& field, double value);
/// Returns the tolerance for pictures that must be equal by default, relaxed by the given bounds. A
/// maxChannelDiff without other bounds must hold for every pixel. A bound on the number of pixels, a
/// window, FLIP or the worst pixel replaces the requirement on every pixel.
[[nodiscard]] scene::Tolerance strictTolerance(const std::map<std::string, double>& given);
/// Returns the bounds that apply, by name. Includes maxDiffRatio if neither maxDiffRatio nor maxDiffPixels
/// is given.
[[nodiscard]] std::map<std::string, double> boundsInForce(scene::Tolerance tolerance);

}  // namespace simreel::golden
