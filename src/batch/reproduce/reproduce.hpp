#pragma once
#include "gl/context.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

struct ReproduceRequest {
  std::filesystem::path file;   ///< a picture, a manifest, or a folder or video that has one
  std::optional<int> frame;     ///< of a manifest; else its last one
  std::filesystem::path scene;  ///< empty: the scene as run that lies beside
  std::vector<std::filesystem::path> assets;
  std::filesystem::path output;  ///< folder for the new picture; empty: it is not kept
  gl::ContextOptions on;
};

struct Reproduction {
  int frame = 0;
  bool same = false;
  std::string state, pixels;             ///< hashes that it has now
  std::vector<std::string> differences;  ///< in words: of results, and of what may be why
};

/// Renders the frame again and compares state and pixels. Throws UserError.
[[nodiscard]] Reproduction reproduce(const ReproduceRequest& request);

}  // namespace simreel::batch
