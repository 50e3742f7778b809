#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace simreel::scene {

/// The line, from 1, of what `path` leads to in the text of a scene or of its sidecar ("objects", "flag";
/// of a list's items "0" is the first); nothing where it does not say that, or is no JSON.
[[nodiscard]] std::optional<int> memberLine(std::string_view text, std::span<const std::string> path);

}  // namespace simreel::scene
