#pragma once
#include "scene/scene.hpp"

#include <string>
#include <string_view>

namespace simreel::serve {

/// Returns a scene's text with one value replaced. Only the bytes of the value change, so comments, order
/// and spacing remain. A missing member is inserted after the last member of its group in the same style,
/// and missing groups on its path are created. An item with the next index of a list is appended. The value
/// is JSON or a bare string. Throws UserError(usage) if the path cannot be followed or the text cannot be
/// parsed.
[[nodiscard]] std::string withValue(std::string_view text, const scene::Override& change);

}  // namespace simreel::serve
