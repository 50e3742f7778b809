#pragma once
#include "gl/context.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

struct ReproduceRequest {
  std::filesystem::path file;   ///< a picture, a manifest, or a folder or video with a manifest
  std::optional<int> frame;     ///< frame number in the manifest; nullopt for the manifest's last frame
  std::filesystem::path scene;  ///< path of the scene; empty to use as-run.json in the picture's folder
  std::vector<std::filesystem::path> assets;
  std::filesystem::path output;  ///< folder for the new picture; empty to discard the picture
  gl::ContextOptions on;
};

struct Reproduction {
  int frame = 0;
  bool same = false;
  std::string state, pixels;  ///< hashes of the frame's new state and pixels
  /// Differences in the results and their possible causes, as sentences.
  std::vector<std::string> differences;
};

/// Renders the frame again and compares its state and pixels. Throws UserError.
[[nodiscard]] Reproduction reproduce(const ReproduceRequest& request);

}  // namespace simreel::batch
