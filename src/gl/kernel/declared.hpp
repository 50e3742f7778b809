#pragma once
#include <set>
#include <string>
#include <string_view>

namespace simreel::gl {

/// Names that a shader's text declares for the program to give, whatever its #if leave out: of uniforms
/// outside blocks, of blocks and their members, and all arguments of macros in capitals that stand by
/// themselves, such as STATE_ARRAY(0, CellBlock, cells).
[[nodiscard]] std::set<std::string, std::less<>> declaredNames(std::string_view text);

}  // namespace simreel::gl
