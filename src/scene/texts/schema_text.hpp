#pragma once
#include "scene/scene.hpp"

#include <span>
#include <string>

namespace simreel::scene {

/// Returns the JSON Schema (draft 2020-12) of scene files, pretty-printed, ending in a newline.
[[nodiscard]] std::string schemaText(std::span<const Kind> kinds);

}  // namespace simreel::scene
