#pragma once
#include <span>

namespace simreel::cli {

/// One exit code as documented for users.
struct ExitMeaning {
  const char* code;
  const char* meaning;  ///< short meaning, for `simreel --help`
  const char* cure;     ///< advice for the user
};

/// Returns all exit codes in ascending order.
[[nodiscard]] std::span<const ExitMeaning> exitMeanings();

}  // namespace simreel::cli
