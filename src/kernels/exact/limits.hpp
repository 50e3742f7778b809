#pragma once
#include "kernels/source/files.hpp"
#include "kernels/spirv/module.hpp"

#include <string>
#include <vector>

namespace simreel::kernels {

/// Returns what no driver takes, or takes forever: groups without threads or with too many, and arrays of
/// an invocation that are too large. `line`: that announces the kernel `entry` in the first file.
[[nodiscard]] std::vector<Mistake> beyondLimits(const Module& module, const Files& files,
                                                const std::string& entry, int line);

/// Returns mistakes of the [numthreads(x, y, z)] of the kernel `entry` in an HLSL file that name constants,
/// for which glslang crashes.
[[nodiscard]] std::vector<Mistake> variableGroups(const Files& files, const std::string& entry);

/// Returns a mistake if a GLSL shader gives its groups no size, or a specialization constant alone.
[[nodiscard]] std::vector<Mistake> withoutLocalSize(const Files& files);

/// Returns a mistake if the kernel `entry` of HLSL is a function without [numthreads(x, y, z)], for which
/// the compiler takes groups of one thread.
[[nodiscard]] std::vector<Mistake> withoutGroups(const Files& files, const std::string& entry);

/// Returns a mistake where the groups of a module that keeps only what it uses share more memory than
/// OpenGL grants.
[[nodiscard]] std::vector<Mistake> beyondShared(const Module& module, const Files& files, int line);

}  // namespace simreel::kernels
