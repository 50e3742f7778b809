#pragma once
#include "kernels/request.hpp"
#include "kernels/shader/shader.hpp"

#include <string>
#include <vector>

namespace simreel::kernels {

/// Returns the names of the kernels that a file announces, without compiling them. Throws UserError(usage)
/// for a file that cannot be read.
[[nodiscard]] std::vector<std::string> kernelNames(const Request& request);

/// Compiles the kernels of a file, in a process of its own: compilers are not made for hostile files.
/// Throws UserError(usage) that reports mistakes at file, line and column.
[[nodiscard]] Shader load(const Request& request);
/// The same in this process.
[[nodiscard]] Shader loadHere(const Request& request);

}  // namespace simreel::kernels
