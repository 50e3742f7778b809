#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace simreel::cli {

/// Returns the names of the shipped scenes in alphabetical order. Returns an empty list if there is no
/// asset folder.
[[nodiscard]] std::vector<std::string> shippedScenes();

/// Returns the file of a scene argument. If no such file exists, "flag" and "scenes/flag.json" name a
/// shipped scene, and a message is printed. Throws UserError(usage) for a misspelt name, a mesh or a
/// picture.
[[nodiscard]] std::string sceneFile(const std::string& name);

/// Passes a scene argument through sceneFile(). Sets `shipped` to true if the argument names a shipped
/// scene.
void findShipped(CLI::Option& option, bool* shipped = nullptr);

}  // namespace simreel::cli
