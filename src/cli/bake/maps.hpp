#pragma once
#include "cli/options/scene_options.hpp"
#include "gl/context.hpp"

#include <optional>
#include <string>

namespace simreel::cli {

/// What `simreel bake --format maps` is asked for.
struct MapsOptions {
  SceneOptions scene;  ///< its size is that of the maps; none: as many texels as the field has cells
  std::string output, object, look;
  gl::ContextOptions on;
  std::optional<std::string> frames;  ///< none: the last one
  bool overwrite = false;
};

/// Writes the maps of every skin of the scene, or of one, or of a field with a look, as
/// OUTPUT/NAME_000000_albedo.png and so on. Throws UserError.
void bakeMaps(const MapsOptions& options);

}  // namespace simreel::cli
