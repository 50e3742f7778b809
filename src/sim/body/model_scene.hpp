#pragma once
#include <filesystem>
#include <string>

namespace simreel::sim {

/// Returns the JSON text of a scene that draws a glTF file on the default stage: its meshes, its first
/// animation as a "body", and its lights (KHR_lights_punctual). If the lights give more than 10 lx or less
/// than 1 lx at the middle of the meshes, they are scaled to 5 lx in total. Returns an empty string for
/// other files. Throws the errors of loadMesh().
[[nodiscard]] std::string sceneAroundModel(const std::filesystem::path& file);

}  // namespace simreel::sim
