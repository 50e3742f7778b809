#pragma once
#include <map>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace simreel::cli {

/// The bounds of a comparison as flags: --max-channel-diff and so on.
struct ToleranceOptions {
  std::map<std::string, std::optional<double>> values;  ///< by field name
  void add(CLI::App& command);
  /// Those on the command line, by field name. Throws UserError(usage) for one outside its range.
  [[nodiscard]] std::map<std::string, double> given() const;
};

}  // namespace simreel::cli
