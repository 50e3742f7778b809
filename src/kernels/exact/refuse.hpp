#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <vector>

namespace simreel::kernels {

/// Returns errors for features that OpenGL 4.5 lacks. Unless `fast` is true, also returns errors for
/// operations whose results differ between drivers. Each feature is reported only at its first occurrence.
[[nodiscard]] std::vector<Mistake> refused(const Module& module, const Files& files, bool fast);

}  // namespace simreel::kernels
