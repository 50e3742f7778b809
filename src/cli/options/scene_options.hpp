#pragma once
#include "scene/scene.hpp"

#include <filesystem>
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
  bool shipped = false;                ///< whether `file` was found by the name of a shipped scene
  std::vector<std::string> overrides;  ///< -D path=value
  std::optional<int> seed;
  std::optional<std::string> size;  ///< WxH
  std::optional<double> fps;
  std::optional<int> samples;
  std::optional<std::string> rasterizer;
  std::vector<std::string> assets;  ///< folders that the scene may read, too
  void add(CLI::App& command);
  /// The same for a command that can do without a scene: `file` is empty then.
  void addOptional(CLI::App& command);
  /// All of them as overrides. Throws UserError(usage).
  [[nodiscard]] std::vector<scene::Override> changes() const;
  /// Reads the scene with all of them applied. --size, --fps, --samples and --seed are shorthands of -D, so
  /// the scene's hash tells them apart. `more` comes last.
  [[nodiscard]] scene::Scene load(const std::vector<scene::Override>& more = {}) const;
  /// The same as words of a command line.
  [[nodiscard]] std::vector<std::string> arguments() const;
};

/// --assets, repeatable.
void addAssets(CLI::App& command, std::vector<std::string>& folders);
/// They as paths. Throws UserError(usage) for one that is no folder.
[[nodiscard]] std::vector<std::filesystem::path> assetFolders(const std::vector<std::string>& folders);
/// Each "path=value" of -D. Throws UserError(usage).
[[nodiscard]] std::vector<scene::Override> parseOverrides(const std::vector<std::string>& texts);

}  // namespace simreel::cli
