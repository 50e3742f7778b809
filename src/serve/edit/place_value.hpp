#pragma once
#include "scene/scene.hpp"

#include <string>
#include <string_view>

namespace simreel::serve {

/// A scene's text with one value in the place of another: only the value's own bytes change, and comments,
/// order and spacing stay. A member that is not there is written after the last one of its group, in the
/// same manner, as is an item that is the next one of a list; groups on the way to it are made. `value` is
/// JSON, or bare text. Throws UserError(usage) where the path leads nowhere or the text cannot be read.
[[nodiscard]] std::string withValue(std::string_view text, const scene::Override& change);

}  // namespace simreel::serve
