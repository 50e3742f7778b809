#pragma once
#include <filesystem>
#include <string>

namespace simreel::sim {

/// Returns a scene that draws a glTF file on the default stage: its meshes, its first animation as a
/// "body", and its lights (KHR_lights_punctual). Lights of more than 10 lx or less than 1 lx at the middle
/// of the meshes are scaled to 5 lx in all. Returns an empty string for other files. Throws the errors of
/// loadMesh().
[[nodiscard]] std::string sceneAroundModel(const std::filesystem::path& file);

}  // namespace simreel::sim
