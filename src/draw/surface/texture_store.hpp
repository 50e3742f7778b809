#pragma once
#include "gl/texture.hpp"

#include <filesystem>
#include <map>

namespace simreel::draw {

/// Pictures of materials: each file is read once. sRGB is decoded on reading a texel; mip maps
/// of mip_levels.hpp. Row 0 of the file is v = 0.
class TextureStore {
 public:
  /// Null for an empty path. Throws UserError: usage for a file that is no picture, inputOutput (or what
  /// readFile says) for one that cannot be read, device for one larger than the device allows.
  const gl::Texture* load(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, gl::Texture> textures_;
};

}  // namespace simreel::draw
