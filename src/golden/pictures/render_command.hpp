#pragma once
#include "base/error.hpp"
#include "golden/pictures/shell_script.hpp"
#include "golden/suite/scene_set.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// How the command of a scene ended.
struct CommandEnd {
  std::optional<UserError> mistake;   ///< of the last try
  std::vector<std::string> failures;  ///< messages of the tries before
};

/// A shell command that makes pictures with any program. {scene} is replaced by a file, {output} by where
/// its picture is to go, FOLDER/name.png; followed by "." or "/" it is FOLDER/name, so that {output}.exr
/// has another kind and {output}/####.png makes several. Without {scene} it runs once, and {output} is
/// FOLDER. The command has both as $SIMREEL_SCENE and $SIMREEL_OUTPUT, too.
struct RenderCommand {
  std::string text;
  std::filesystem::path folder;
  double timeout = 0;  ///< seconds after which it is ended; 0: never
  int retries = 0;     ///< further tries of a command that fails

  /// Throws UserError(usage) for one without {output}.
  void check() const;
  [[nodiscard]] bool eachScene() const { return text.find("{scene}") != std::string::npos; }
  /// To be shown: both words filled in, where they stand for names that no shell takes for anything else.
  [[nodiscard]] std::string of(const SceneFile& scene) const;
  /// For each of the chosen scenes, by index: removes what an earlier run left of its pictures, runs the
  /// command, and tells how that failed, or that it made none. So many run at once. Throws Interrupted
  /// after a signal.
  [[nodiscard]] std::vector<CommandEnd> runAll(const std::vector<SceneFile>& scenes,
                                               std::vector<std::size_t> chosen, std::size_t jobs) const;

 private:
  [[nodiscard]] std::vector<Placeholder> placeholders(const SceneFile& scene) const;
  [[nodiscard]] std::string outputOf(const SceneFile& scene, char after) const;
  void makeRoom(const SceneFile& scene, const std::vector<SceneFile>& scenes) const;
  void run(const SceneFile& scene, const std::vector<SceneFile>& scenes) const;
  void checkMade(const SceneFile& scene, const std::vector<SceneFile>& scenes) const;
  void tryAll(const std::vector<SceneFile>& scenes, const std::vector<std::size_t>& chosen,
              std::size_t jobs, std::vector<CommandEnd>& ends) const;
  /// What lies in the folder of its pictures, and is not another scene's.
  [[nodiscard]] std::vector<std::string> madeOf(const SceneFile& scene,
                                                const std::vector<SceneFile>& scenes) const;
};

/// The files to render: those given, and all below folders given, hidden ones apart; named by their paths
/// without extension. Throws as findScenes() does.
[[nodiscard]] std::vector<SceneFile> findInputs(std::span<const std::string> paths);

/// The scene whose picture this is: the longest name that the picture's path begins with, up to ".", "/" or
/// the end; nullptr: none.
[[nodiscard]] const SceneFile* ownerOf(const std::string& picture, const std::vector<SceneFile>& scenes);

}  // namespace simreel::golden
