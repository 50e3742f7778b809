#pragma once
#include "scene/test.hpp"

#include <map>
#include <string>

namespace simreel::golden {

/// Sets the bound of that name. The name is that of one of tolerance.bounds() (an invariant).
void setBound(scene::Tolerance& tolerance, const std::string& field, double value);
/// What bounds from a person allow where nothing is allowed otherwise: equality without any; maxChannelDiff
/// alone is kept by every pixel; a bound on how many pixels, on a window, on FLIP or on the worst pixel
/// replaces that.
[[nodiscard]] scene::Tolerance strictTolerance(const std::map<std::string, double>& given);
/// The bounds that hold, by name; maxDiffRatio is among them when neither it nor maxDiffPixels was
/// given.
[[nodiscard]] std::map<std::string, double> boundsInForce(scene::Tolerance tolerance);

}  // namespace simreel::golden
