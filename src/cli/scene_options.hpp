#pragma once
#include "scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Options of every command that reads a scene to run it.
struct SceneOptions {
  std::string file;
  std::vector<std::string> overrides;  ///< -D path=value
  std::optional<int> seed;
  std::optional<std::string> size;  ///< WxH
  std::optional<double> fps;
  std::optional<int> samples;
  void add(CLI::App& command);
  /// Reads the scene with all of them applied. --size, --fps, --samples and --seed are shorthands of -D, so
  /// the scene's hash tells them apart. `more` comes last.
  [[nodiscard]] scene::Scene load(const std::vector<scene::Override>& more = {}) const;
  /// The same as words of a command line.
  [[nodiscard]] std::vector<std::string> arguments() const;
};

/// Each "path=value" of -D. Throws UserError(usage).
[[nodiscard]] std::vector<scene::Override> parseOverrides(const std::vector<std::string>& texts);

}  // namespace simreel::cli
