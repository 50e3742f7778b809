#pragma once
#include "gl/context.hpp"

#include <cstddef>
#include <string>

namespace simreel::cli {

/// --jobs: a number, or "auto": one a processor. Throws UserError(usage).
[[nodiscard]] std::size_t jobCount(const std::string& jobs);
/// The same, and no fewer than devices are listed.
[[nodiscard]] std::size_t jobCount(const std::string& jobs, const gl::ContextOptions& on);

}  // namespace simreel::cli
