#pragma once
#include "scene/value/fields.hpp"

#include <span>
#include <string>

namespace simreel::scene {

/// Returns advice for an object's key that is not the name of a kind. The advice differs for a key of
/// materials, a synonym of a kind and a misspelt kind.
[[nodiscard]] std::string hintForKind(const std::string& key, std::span<const Kind> kinds);

}  // namespace simreel::scene
