#pragma once
#include "scene/value/fields.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// Returns the words that the parameter `name` of this kind can take. Returns an empty list if the
/// parameter is not a choice of words, or is inside a group.
[[nodiscard]] std::vector<std::string> choicesOf(const Kind& kind, std::string_view name);

}  // namespace simreel::scene
