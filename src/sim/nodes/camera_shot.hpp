#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <memory>
#include <string_view>

namespace simreel::sim {

/// Opens a camera of a glTF 2.0 or GLB file for a scene: a camera of the default scene, moved by its node.
/// Ignores scales, as the specification requires (3.10.1), and the file's aspect ratio. Throws UserError:
/// usage for a file without cameras, an unknown name or an unsupported kind; otherwise the errors of
/// loadMesh().
[[nodiscard]] std::shared_ptr<const scene::CameraShot> openCamera(const scene::CameraFile& wanted);

/// Parses a camera from a file's text like openCamera(), but in the calling process instead of a separate
/// one.
[[nodiscard]] std::shared_ptr<const scene::CameraShot> readCamera(const scene::CameraFile& wanted,
                                                                  std::string_view text);

}  // namespace simreel::sim
