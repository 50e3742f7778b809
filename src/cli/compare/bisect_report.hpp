#pragma once
#include "golden/bisect/bisect.hpp"

#include <functional>
#include <string>

namespace simreel::cli {

/// Result of `simreel bisect`, with additional texts for the report.
struct BisectReport {
  golden::BisectResult result;
  std::string commandHere, commandThere;
  /// Name of the first differing element, such as "particle (12, 30)". Empty if it has no name.
  std::string element;
};

/// Returns the report as readable text that ends with a newline.
[[nodiscard]] std::string bisectText(const BisectReport& report);
/// Returns the report as indented JSON that ends with a newline.
[[nodiscard]] std::string bisectJson(const BisectReport& report);

}  // namespace simreel::cli
