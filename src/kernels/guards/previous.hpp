#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <string>
#include <vector>

namespace simreel::kernels {

/// Suffix of the block that holds a buffer's state before the dispatch.
inline constexpr const char* previousSuffix = ".previous";

/// Redirects all loads of the named buffers to a separate block "NAME.previous". A buffer that a kernel
/// only reads or only writes is left unchanged. Atomic operations on a redirected buffer are errors.
[[nodiscard]] std::vector<Mistake> readPrevious(Module& module, const Files& files, bool hlsl,
                                                const std::vector<std::string>& names);

}  // namespace simreel::kernels
