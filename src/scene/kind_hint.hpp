#pragma once
#include "scene/value/fields.hpp"

#include <span>
#include <string>

namespace simreel::scene {

/// Returns advice for a key of an object that is no kind: a key of materials, another word for a kind, or
/// the most similar kind.
[[nodiscard]] std::string hintForKind(const std::string& key, std::span<const Kind> kinds);

}  // namespace simreel::scene
