#pragma once
#include <set>
#include <string>
#include <string_view>

namespace simreel::gl {

/// Returns the names of the inputs that a shader's text declares in all branches of #if. The inputs are
/// uniforms outside blocks, blocks and their members, and all arguments of stand-alone macro calls in
/// capitals, such as STATE_ARRAY(0, CellBlock, cells).
[[nodiscard]] std::set<std::string, std::less<>> declaredNames(std::string_view text);

}  // namespace simreel::gl
