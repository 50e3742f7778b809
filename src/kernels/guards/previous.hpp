#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <string>
#include <vector>

namespace simreel::kernels {

/// End of the name of a block that holds a buffer's state before the dispatch.
inline constexpr const char* previousSuffix = ".previous";

/// Redirects all loads of some buffers, by the user's names, to another block: "NAME.previous". A buffer
/// that a kernel only reads or only writes stays as it is. Atomic operations on a redirected buffer are
/// mistakes.
[[nodiscard]] std::vector<Mistake> readPrevious(Module& module, const Files& files, bool hlsl,
                                                const std::vector<std::string>& names);

}  // namespace simreel::kernels
