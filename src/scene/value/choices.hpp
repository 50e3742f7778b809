#pragma once
#include "scene/value/fields.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// The words that the parameter `name` of this kind of object takes, where it is a choice of words among
/// the kind's own parameters (not in a group of them); empty otherwise.
[[nodiscard]] std::vector<std::string> choicesOf(const Kind& kind, std::string_view name);

}  // namespace simreel::scene
