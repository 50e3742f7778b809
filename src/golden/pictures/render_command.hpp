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

/// Result of running the command for a scene.
struct CommandEnd {
  std::optional<UserError> mistake;   ///< error of the last attempt; empty if it succeeded
  std::vector<std::string> failures;  ///< messages of the earlier attempts
};

/// A shell command that makes pictures with any program. {scene} is replaced by the scene's file. {output}
/// is normally replaced by the picture's path FOLDER/name.png. If "." or "/" follows, {output} is replaced
/// by FOLDER/name, so that {output}.exr selects another format and {output}/####.png makes several
/// pictures. A command without {scene} runs once, with FOLDER for {output}. The command also gets both
/// values as $SIMREEL_SCENE and $SIMREEL_OUTPUT.
struct RenderCommand {
  std::string text;
  std::filesystem::path folder;
  double timeout = 0;  ///< time (s) after which the command is killed; 0 means never
  int retries = 0;     ///< number of further attempts after a failure

  /// Throws UserError(usage) if the command has no {output}.
  void check() const;
  [[nodiscard]] bool eachScene() const { return text.find("{scene}") != std::string::npos; }
  /// Returns the command for display. Fills in both placeholders if the names need no shell quotes.
  [[nodiscard]] std::string of(const SceneFile& scene) const;
  /// Runs the command for each of the chosen scenes (indices), with up to `jobs` commands at the same time.
  /// First removes pictures of an earlier run. Returns the error of each scene. A scene for which no
  /// picture was made also has an error. Throws Interrupted after a signal.
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
  /// Returns the pictures of the scene in the output folder, without pictures of other scenes.
  [[nodiscard]] std::vector<std::string> madeOf(const SceneFile& scene,
                                                const std::vector<SceneFile>& scenes) const;
};

/// Returns the files to render. These are the given files, and all files except hidden ones below the given
/// folders. The name of a file is its path without extension. Throws the same errors as findScenes().
[[nodiscard]] std::vector<SceneFile> findInputs(std::span<const std::string> paths);

/// Returns the scene to which a picture belongs. The picture's path must start with the scene's name,
/// followed by ".", "/" or the end. If several names match, the longest one counts. Returns nullptr if no
/// scene matches.
[[nodiscard]] const SceneFile* ownerOf(const std::string& picture, const std::vector<SceneFile>& scenes);

}  // namespace simreel::golden
