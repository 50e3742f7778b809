#pragma once
#include <map>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Tolerances of a comparison as flags: --max-channel-diff etc.
struct ToleranceOptions {
  std::map<std::string, std::optional<double>> values;  ///< values by name of the tolerance's field
  void add(CLI::App& command);
  /// Returns the tolerances given on the command line, by field name. Throws UserError(usage) for a value
  /// outside its range.
  [[nodiscard]] std::map<std::string, double> given() const;
};

}  // namespace simreel::cli
