#pragma once
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Flags for differences that a comparison of pictures ignores.
struct AllowanceOptions {
  bool ignoreAntialiased = false;
  std::optional<int> searchRadius;
  std::string mask;
  void add(CLI::App& command);
};

}  // namespace simreel::cli
