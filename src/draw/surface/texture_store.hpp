#pragma once
#include "gl/texture.hpp"

#include <filesystem>
#include <map>

namespace simreel::draw {

/// Loads the image files of materials as textures with the mip levels of mip_levels.hpp. Each file is read
/// once. Texture reads decode sRGB. Row 0 of the file is at v = 0.
class TextureStore {
 public:
  /// Returns the texture of a file, or null for an empty path. Throws UserError(usage) if the file is not
  /// an image, UserError(device) if it is larger than the device allows, and UserError(inputOutput) (or
  /// what readFile() throws) if it cannot be read.
  const gl::Texture* load(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, gl::Texture> textures_;
};

}  // namespace simreel::draw
