#pragma once
#include "sim/world/world.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace simreel::cli {

/// What `simreel bake` is asked for where all frames of an object go into one file.
struct SequencesOptions {
  std::string format;                ///< of frame::sequenceFormats
  std::filesystem::path output;      ///< folder
  std::vector<std::size_t> objects;  ///< which have meshes
  std::vector<int> frames;
  double fps = 30;
  bool overwrite = false;
  /// Lines about an object at the present frame, for files that have room for them.
  std::function<std::vector<std::string>(std::size_t object)> comments;
};

/// Writes OUTPUT/NAME.glb, or .pc2 or .mdd with OUTPUT/NAME.obj, the first frame, beside it. Throws
/// UserError; after an interrupt or a mistake no frame's file is there that is not whole.
void bakeSequences(sim::World& world, const SequencesOptions& options);

}  // namespace simreel::cli
