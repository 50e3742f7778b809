#pragma once
#include "golden/bisect/bisect.hpp"

#include <functional>
#include <string>

namespace simreel::cli {

/// What the result of `simreel bisect` is told with, beside the result.
struct BisectReport {
  golden::BisectResult result;
  std::string commandHere, commandThere;
  /// What a user calls the first element that differs, "particle (12, 30)"; empty where none is known.
  std::string element;
};

/// For people; ends in a newline.
[[nodiscard]] std::string bisectText(const BisectReport& report);
/// As JSON, pretty-printed; ends in a newline.
[[nodiscard]] std::string bisectJson(const BisectReport& report);

}  // namespace simreel::cli
