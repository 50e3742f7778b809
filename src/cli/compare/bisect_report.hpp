#pragma once
#include "golden/bisect/bisect.hpp"

#include <functional>
#include <string>

namespace simreel::cli {

/// Result of `simreel bisect` with the texts that its report needs.
struct BisectReport {
  golden::BisectResult result;
  std::string commandHere, commandThere;
  /// Name of the first differing element, "particle (12, 30)"; empty if it has no name.
  std::string element;
};

/// Returns the report as text for people; ends in a newline.
[[nodiscard]] std::string bisectText(const BisectReport& report);
/// Returns the report as indented JSON; ends in a newline.
[[nodiscard]] std::string bisectJson(const BisectReport& report);

}  // namespace simreel::cli
