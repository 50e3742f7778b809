#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace simreel::cli {

/// Returns the names of the shipped scenes in alphabetical order; empty if there is no asset folder.
[[nodiscard]] std::vector<std::string> shippedScenes();

/// Returns the file of a scene argument. "flag" and "scenes/flag.json" name a shipped scene if no such file
/// exists; a message then says so. Throws UserError(usage) for a misspelt name, a mesh or a picture.
[[nodiscard]] std::string sceneFile(const std::string& name);

/// Makes a scene argument pass through sceneFile(). Sets `shipped` to true if the argument names a shipped
/// scene.
void findShipped(CLI::Option& option, bool* shipped = nullptr);

}  // namespace simreel::cli
