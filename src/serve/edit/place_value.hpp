#pragma once
#include "scene/scene.hpp"

#include <string>
#include <string_view>

namespace simreel::serve {

/// Returns a scene's text with one value replaced. Only the bytes of the value change; comments, order and
/// spacing stay. A missing member is inserted after the last one of its group in the same style, and
/// missing groups on its path are created. The next item of a list is appended likewise. The value is JSON
/// or a bare string. Throws UserError(usage) if the path leads nowhere or the text cannot be parsed.
[[nodiscard]] std::string withValue(std::string_view text, const scene::Override& change);

}  // namespace simreel::serve
