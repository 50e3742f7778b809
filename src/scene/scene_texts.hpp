#pragma once
#include "scene/scene.hpp"

#include <span>
#include <string>
#include <string_view>

namespace simreel::scene {

/// JSON Schema (draft 2020-12) of scene files, pretty-printed, ending in a newline.
[[nodiscard]] std::string schemaText(std::span<const Kind> kinds);

/// Help for one kind (or "scene", "render", "camera", ..., "material"): name, default, range, unit,
/// sentence. Throws UserError(usage) with a suggestion for an unknown name.
[[nodiscard]] std::string helpText(std::string_view name, std::span<const Kind> kinds);
/// One line per kind and per scene section.
[[nodiscard]] std::string listText(std::span<const Kind> kinds);

}  // namespace simreel::scene
