#pragma once
#include "draw/surface/skin_textures.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <map>

namespace simreel::draw {

struct SkinTexelKernel;

/// The textures of skins as lists of texels, all that there is of one together: software drivers find those
/// of a buffer several times as fast as those of a 2-D texture.
class SkinTexels {
 public:
  /// Brings the list of an entry, which stays where it is, up to date with its textures.
  void update(const SkinTextures::Entry& entry);
  /// View of the list of an entry that has been brought up to date: RGBA32UI, level after level, of each
  /// texel eight halves as glsl/draw/exact/surface/skin_texels.comp says.
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
