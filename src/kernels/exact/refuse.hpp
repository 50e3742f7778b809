#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <vector>

namespace simreel::kernels {

/// What OpenGL 4.5 lacks, and unless `fast` what has not the same bits everywhere: each where it first
/// stands.
[[nodiscard]] std::vector<Mistake> refused(const Module& module, const Files& files, bool fast);

}  // namespace simreel::kernels
