#pragma once
#include <string>
#include <string_view>

namespace simreel::kernels {

/// Returns true for a character that may be part of an identifier.
[[nodiscard]] bool partOfName(char c);

/// Returns a user's shader text in a form that glslang accepts. Every token stays on its line. Removes the
/// byte order mark and carriage returns. Blanks syntax of other compilers (packoffset, Godot's
/// "#[compute]", unorm and snorm before a type). Rewrites code that Microsoft's compiler tolerates: integer
/// literals of more than 32 bits, a loop variable that a later loop reuses, swizzles of several matrix
/// elements, and const before a global without a value.
[[nodiscard]] std::string plain(std::string_view text);

/// Returns an error message if brackets are nested too deeply or expressions are too long for a
/// recursive-descent compiler. Returns an empty string otherwise.
[[nodiscard]] std::string tooDeep(std::string_view text);

}  // namespace simreel::kernels
