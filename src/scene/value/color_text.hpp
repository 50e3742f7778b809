#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::scene {

/// Returns the linear RGB of "#rgb", "#rrggbb" (sRGB) or a named colour of CSS. Ignores case. Returns
/// nullopt for any other text.
[[nodiscard]] std::optional<glm::vec3> colorOf(std::string_view text);

/// Returns the named colours of CSS in alphabetical order.
[[nodiscard]] std::vector<std::string> colorNames();

}  // namespace simreel::scene
