#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <filesystem>
#include <map>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Loads material pictures as lists of texels. Each file is read once. Row 0 of the file is v = 0.
class TexelLists {
 public:
  struct List {
    gl::Buffer texels;
    gl::Texture view;  ///< RGBA32UI: first the start index of each level, then the texels in linear light
                       ///< in units of 1/65535, each as (r + 2^16 g, b) followed by the same of the next
                       ///< texel in the row (after the last: the first)
    glm::ivec2 size{0, 0};
    int levels = 0;  ///< mip levels of mip_levels.hpp, down to 1x1
  };
  /// Returns null for an empty path. Throws UserError(usage) if the file is not a picture,
  /// UserError(inputOutput) (or what readFile() throws) if it cannot be read, UserError(device) if it is
  /// larger than the device allows.
  const List* load(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, List> lists_;
};

}  // namespace simreel::draw
