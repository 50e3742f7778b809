#pragma once
#include "cli/options/scene_options.hpp"
#include "gl/context.hpp"

#include <optional>
#include <string>

namespace simreel::cli {

/// Options of `simreel bake --format maps`.
struct MapsOptions {
  SceneOptions scene;  ///< options of the scene; `scene.size` is the size of the maps, and if absent, a map
                       ///< has one texel per cell of the field
  std::string output, object, look;
  gl::ContextOptions on;
  std::optional<std::string> frames;  ///< frames to bake; if absent, only the last frame is baked
  bool overwrite = false;
};

/// Writes maps of one skin or of every skin in the scene, or of a field with a look, as
/// OUTPUT/NAME_000000_albedo.png etc. Throws UserError.
void bakeMaps(const MapsOptions& options);

}  // namespace simreel::cli
