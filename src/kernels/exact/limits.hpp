#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <string>
#include <vector>

namespace simreel::kernels {

/// Returns mistakes for code that drivers reject or compile forever: workgroups with no threads or too many
/// threads, and too large arrays in private memory. `line` is the line of the first file that declares the
/// kernel `entry`.
[[nodiscard]] std::vector<Mistake> beyondLimits(const Module& module, const Files& files,
                                                const std::string& entry, int line);

/// Returns mistakes for a [numthreads(x, y, z)] of the kernel `entry` in an HLSL file that contains names
/// of constants. glslang crashes for them.
[[nodiscard]] std::vector<Mistake> variableGroups(const Files& files, const std::string& entry);

/// Returns a mistake if a GLSL shader does not give its workgroups a size, or gives it only by a
/// specialization constant.
[[nodiscard]] std::vector<Mistake> withoutLocalSize(const Files& files);

/// Returns a mistake if the HLSL kernel `entry` lacks [numthreads(x, y, z)]. glslang would silently use
/// workgroups of one thread.
[[nodiscard]] std::vector<Mistake> withoutGroups(const Files& files, const std::string& entry);

/// Returns a mistake if a workgroup uses more shared memory than OpenGL guarantees. Unused code must have
/// been removed from the module. `line` is the line that declares the kernel.
[[nodiscard]] std::vector<Mistake> beyondShared(const Module& module, const Files& files, int line);

}  // namespace simreel::kernels
