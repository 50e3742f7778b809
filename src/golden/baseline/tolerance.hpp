#pragma once
#include "scene/test.hpp"

#include <map>
#include <span>
#include <string>

namespace simreel::golden {

/// Names of the bounds, as scenes, baselines and (with '-') the command line spell them.
[[nodiscard]] std::span<const char* const> toleranceFields();
/// Sets the bound of that name. The name is one of toleranceFields() (an invariant).
void setBound(scene::Tolerance& tolerance, const std::string& field, double value);
/// The bounds that hold, by name; max_diff_ratio is among them when neither it nor max_diff_pixels was
/// given.
[[nodiscard]] std::map<std::string, double> boundsInForce(const scene::Tolerance& tolerance);

}  // namespace simreel::golden
