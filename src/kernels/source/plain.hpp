#pragma once
#include <string>
#include <string_view>

namespace simreel::kernels {

/// True for a character that may stand in a name.
[[nodiscard]] bool partOfName(char c);

/// A user's shader text as glslang can read it, every token in its line: without byte order mark and
/// carriage returns, with blanks for what only other compilers know (packoffset, Godot's "#[compute]",
/// unorm and snorm before a type), and with what Microsoft's compiler forgives made right: whole numbers of
/// more than 32 bits, a loop's variable that a later loop uses, several elements of a matrix at once,
/// const before a global that has no value.
[[nodiscard]] std::string plain(std::string_view text);

/// Says so where brackets are nested more deeply, or operators follow each other for longer, than a
/// compiler that calls itself for each can bear; empty otherwise.
[[nodiscard]] std::string tooDeep(std::string_view text);

}  // namespace simreel::kernels
