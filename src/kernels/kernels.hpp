#pragma once
#include "kernels/request.hpp"
#include "kernels/shader/shader.hpp"

#include <string>
#include <vector>

namespace simreel::kernels {

/// Returns the names of the kernels that a file declares, without compiling them. Throws UserError(usage)
/// if the file cannot be read.
[[nodiscard]] std::vector<std::string> kernelNames(const Request& request);

/// Compiles the kernels of a file in a separate process, because the compilers are not hardened against
/// malicious files. Throws UserError(usage) that lists the errors with file, line and column.
[[nodiscard]] Shader load(const Request& request);
/// Does the same as load() in the calling process.
[[nodiscard]] Shader loadHere(const Request& request);

}  // namespace simreel::kernels
