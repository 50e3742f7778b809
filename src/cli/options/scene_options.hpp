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
  bool shipped = false;                ///< true if `file` is a shipped scene that was found by its name
  std::vector<std::string> overrides;  ///< values of -D, each "path=value"
  std::optional<int> seed;
  std::optional<std::string> size;  ///< value of --size, "WxH"
  std::optional<double> fps;
  std::optional<double> turn;  ///< time (s) in which the camera orbits the scene once
  std::optional<int> samples;
  std::optional<std::string> rasterizer;
  std::optional<std::string> overlay;
  std::vector<std::string> assets;  ///< additional folders from which the scene may read files
  void add(CLI::App& command);
  /// Adds the options to a command whose scene is optional. Without a scene, `file` is empty.
  void addOptional(CLI::App& command);
  /// Returns all options except --assets as overrides. Throws UserError(usage).
  [[nodiscard]] std::vector<scene::Override> changes() const;
  double addOrbit(std::vector<scene::Override>& changes) const;
  /// Reads the scene with all options applied, followed by `more`. --size, --fps, --samples and --seed are
  /// abbreviations of -D, so they change the scene's hash.
  [[nodiscard]] scene::Scene load(const std::vector<scene::Override>& more = {}) const;
  /// Returns all options as command-line arguments.
  [[nodiscard]] std::vector<std::string> arguments() const;
};

/// Adds --assets, which may be repeated.
void addAssets(CLI::App& command, std::vector<std::string>& folders);
/// Returns the asset folders as paths. Throws UserError(usage) for a path that is not a folder.
[[nodiscard]] std::vector<std::filesystem::path> assetFolders(const std::vector<std::string>& folders);
/// Parses each "path=value" of -D. Throws UserError(usage).
[[nodiscard]] std::vector<scene::Override> parseOverrides(const std::vector<std::string>& texts);

}  // namespace simreel::cli
