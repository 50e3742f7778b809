#pragma once
#include "draw/surface/skin_textures.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <map>

namespace simreel::draw {

struct SkinTexelKernel;

/// Copies of skin textures as lists of texels, one list per skin. Software drivers read texels of a buffer
/// several times as fast as texels of a 2-D texture.
class SkinTexels {
 public:
  /// Updates the list of a skin from its textures. The entry must keep its address.
  void update(const SkinTextures::Entry& entry);
  /// Returns the view of an updated entry's list: RGBA32UI, level by level, each texel eight half floats
  /// (glsl/draw/exact/surface/skin_texels.comp).
  [[nodiscard]] const gl::Texture& find(const SkinTextures::Entry& entry) const {
    return lists_.at(&entry).view;
  }
  [[nodiscard]] const gl::Buffer& buffer(const SkinTextures::Entry& entry) const {
    return lists_.at(&entry).texels;
  }
  [[nodiscard]] int count(const SkinTextures::Entry& entry) const { return lists_.at(&entry).count; }

 private:
  struct List {
    gl::Buffer texels;
    gl::Texture view;
    int count = 0;
  };
  std::map<const SkinTextures::Entry*, List> lists_;
  gl::Kernel<SkinTexelKernel> kernel_;
};

}  // namespace simreel::draw
