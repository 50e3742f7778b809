#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <filesystem>
#include <map>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Loads the image files of materials as lists of texels. Each file is read once. Row 0 of the file is at v
/// = 0.
class TexelLists {
 public:
  struct List {
    gl::Buffer texels;
    /// RGBA32UI. The list holds the start index of each level, then the texels in linear light, in units of
    /// 1/65535. An entry packs a texel and its right neighbour. The right neighbour of a row's last texel
    /// is the row's first texel. Each texel takes two words: r + 2^16 g, then b.
    gl::Texture view;
    glm::ivec2 size{0, 0};
    int levels = 0;  ///< number of mip levels (mip_levels.hpp), down to 1x1
  };
  /// Returns the list of a file, or null for an empty path. Throws UserError(usage) if the file is not an
  /// image, UserError(device) if it is larger than the device allows, and UserError(inputOutput) (or what
  /// readFile() throws) if it cannot be read.
  const List* load(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, List> lists_;
};

}  // namespace simreel::draw
