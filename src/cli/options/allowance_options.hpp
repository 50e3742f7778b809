#pragma once
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace simreel::cli {

/// What pictures may differ in, as flags.
struct AllowanceOptions {
  bool ignoreAntialiased = false;
  std::optional<int> searchRadius;
  std::string mask;
  void add(CLI::App& command);
};

}  // namespace simreel::cli
