#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <string>
#include <vector>

namespace simreel::kernels {

/// End of the name of a block that holds a buffer's state before the dispatch.
inline constexpr const char* previousSuffix = ".previous";

/// Makes all loads of some buffers, by the user's names, those of another block: "NAME.previous". Buffers
/// that a kernel does not both read and write stay as they are. Atomic operations on the others are
/// mistakes.
[[nodiscard]] std::vector<Mistake> readPrevious(Module& module, const Files& files, bool hlsl,
                                                const std::vector<std::string>& names);

}  // namespace simreel::kernels
