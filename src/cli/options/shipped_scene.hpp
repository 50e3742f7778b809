#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace simreel::cli {

/// Names of the shipped scenes, in alphabetical order; empty where there is no asset folder.
[[nodiscard]] std::vector<std::string> shippedScenes();

/// The file that a scene argument names. "flag" and "scenes/flag.json" name a shipped scene where no such
/// file exists, and a line says so. Throws UserError(usage) for a misspelt name and for a mesh or a
/// picture.
[[nodiscard]] std::string sceneFile(const std::string& name);

/// Makes a scene argument go through sceneFile(). `shipped`: set where it named a shipped scene.
void findShipped(CLI::Option& option, bool* shipped = nullptr);

}  // namespace simreel::cli
