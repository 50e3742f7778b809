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
  std::vector<std::string> overrides;  ///< -D path=value
  std::optional<int> seed;
  std::optional<std::string> size;  ///< WxH
  std::optional<double> fps;
  std::optional<int> samples;
  std::optional<std::string> rasterizer;
  std::vector<std::string> assets;  ///< folders that the scene may read, too
  void add(CLI::App& command);
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
/// The frames that --frames names, ascending; not given: all of the scene. Warns of those beyond its end.
[[nodiscard]] std::vector<int> chosenFrames(const std::optional<std::string>& text,
                                            const scene::Scene& scene);
/// Warns where a frame that is asked for lies beyond the scene's end.
void warnBeyondEnd(int frame, const scene::Scene& scene);
/// Each "path=value" of -D. Throws UserError(usage).
[[nodiscard]] std::vector<scene::Override> parseOverrides(const std::vector<std::string>& texts);

}  // namespace simreel::cli
