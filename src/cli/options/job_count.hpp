#pragma once
#include "gl/context.hpp"

#include <cstddef>
#include <string>

namespace simreel::cli {

/// Parses --jobs: a number, or "auto" for one job per processor. Throws UserError(usage).
[[nodiscard]] std::size_t jobCount(const std::string& jobs);
/// Parses --jobs. Returns that number, or the number of listed devices if it is greater.
[[nodiscard]] std::size_t jobCount(const std::string& jobs, const gl::ContextOptions& on);

}  // namespace simreel::cli
