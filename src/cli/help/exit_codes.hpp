#pragma once
#include <span>

namespace simreel::cli {

/// One exit code as users read it.
struct ExitMeaning {
  const char* code;
  const char* meaning;  ///< short, for `simreel --help`
  const char* cure;     ///< what a user does about it
};

/// All exit codes, in ascending order.
[[nodiscard]] std::span<const ExitMeaning> exitMeanings();

}  // namespace simreel::cli
