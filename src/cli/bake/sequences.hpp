#pragma once
#include "frame/mesh/gltf_materials.hpp"
#include "sim/world/world.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace simreel::cli {

/// Options of `simreel bake` for files that each contain all frames of an object.
struct SequencesOptions {
  std::string format;                ///< file format, one of frame::sequenceFormats
  std::filesystem::path output;      ///< output folder
  std::vector<std::size_t> objects;  ///< indices of the objects to write; each object has a mesh
  std::vector<int> frames;
  double fps = 30;
  bool overwrite = false;
  /// Returns the comment lines about an object at the current frame, for formats that allow comments.
  std::function<std::vector<std::string>(std::size_t object)> comments;
  frame::SkinPicturesOf skins = {};  ///< returns the pictures of a material at the current frame, for glb
};

/// Writes OUTPUT/NAME.glb, or OUTPUT/NAME.pc2 or .mdd together with the first frame as OUTPUT/NAME.obj.
/// Throws UserError. An interrupt or an error leaves no incomplete file.
void bakeSequences(sim::World& world, const SequencesOptions& options);

}  // namespace simreel::cli
