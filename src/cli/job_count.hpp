#pragma once
#include <cstddef>
#include <string>

namespace simreel::cli {

/// --jobs: a number, or "auto": one a processor. Throws UserError(usage).
[[nodiscard]] std::size_t jobCount(const std::string& jobs);

}  // namespace simreel::cli
