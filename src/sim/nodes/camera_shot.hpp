#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <memory>
#include <string_view>

namespace simreel::sim {

/// Opens a camera of a glTF 2.0 or GLB file for a scene: a camera of the default scene, moved by its node.
/// As the specification says (3.10.1), scales are ignored; the file's aspect ratio is ignored, too. Throws
/// UserError: usage for a file without cameras, an unknown name or an unsupported kind; else as loadMesh()
/// does.
[[nodiscard]] std::shared_ptr<const scene::CameraShot> openCamera(const scene::CameraFile& wanted);

/// Parses a camera from a file's text as openCamera() does, but within this process.
[[nodiscard]] std::shared_ptr<const scene::CameraShot> readCamera(const scene::CameraFile& wanted,
                                                                  std::string_view text);

}  // namespace simreel::sim
