#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace simreel::scene {

/// Returns the 1-based line of the member that `path` names in the JSON text of a scene or its sidecar.
/// Each element of the path is an object's key or a list's zero-based index: {"objects", "flag"}. Returns
/// nullopt if the member does not exist or the text is not JSON.
[[nodiscard]] std::optional<int> memberLine(std::string_view text, std::span<const std::string> path);

}  // namespace simreel::scene
