#pragma once
#include <string>
#include <vector>

namespace simreel::scene {

/// Returns the names of the shipped scenes in alphabetical order. Returns an empty list if there is no
/// asset folder.
[[nodiscard]] std::vector<std::string> shippedScenes();

/// Returns the file that the name of a scene stands for. If no file of that name exists, a name such as
/// "flag" or "scenes/flag.json" stands for a shipped scene, and a message is printed. Throws
/// UserError(usage) for a misspelt name or a picture.
[[nodiscard]] std::string sceneFile(const std::string& name);

}  // namespace simreel::scene
