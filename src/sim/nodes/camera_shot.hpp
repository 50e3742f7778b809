#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <memory>
#include <string_view>

namespace simreel::sim {

/// The camera that a scene asks for of a glTF 2.0 or GLB file: one of the default scene,
/// which stands and turns as its node does; scales are ignored, as the specification says (3.10.1), and so
/// is the file's aspect ratio. Throws UserError: usage for a file without cameras, a name that none has or
/// a kind that is not drawn, else as loadMesh() does.
[[nodiscard]] std::shared_ptr<const scene::CameraShot> openCamera(const scene::CameraFile& wanted);

/// The same of a file's text, in this process.
[[nodiscard]] std::shared_ptr<const scene::CameraShot> readCamera(const scene::CameraFile& wanted,
                                                                  std::string_view text);

}  // namespace simreel::sim
