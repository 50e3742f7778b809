#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <filesystem>
#include <map>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Pictures of materials as lists of texels: each file is read once. Row 0 of the file is v = 0.
class TexelLists {
 public:
  struct List {
    gl::Buffer texels;
    gl::Texture
        view;  ///< RGBA32UI: of each level where it begins, then texels of linear light in 1/65535 as
               ///< r + 2^16 g, b, and the same of the next one of the row, behind the last the first
    glm::ivec2 size{0, 0};
    int levels = 0;  ///< mip maps of mip_levels.hpp, down to 1x1
  };
  /// Null for an empty path. Throws UserError: usage for a file that is no picture, inputOutput (or what
  /// readFile says) for one that cannot be read, device for one larger than the device allows.
  const List* load(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, List> lists_;
};

}  // namespace simreel::draw
