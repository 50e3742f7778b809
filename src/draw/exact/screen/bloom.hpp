#pragma once
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

struct BloomFirst;
struct BloomDown;
struct BloomUp;

/// Computes bloom, light scattered around bright areas, in exact arithmetic. BloomPass computes it with the
/// driver's texture filters.
class Bloom {
 public:
  Bloom(const scene::Bloom& bloom, glm::ivec2 size);
  /// True if the bloom is ever above 0 during the scene.
  [[nodiscard]] static bool on(const scene::Bloom& bloom) {
    return bloom.strength.moves() || bloom.strength.at(0) > 0;
  }
  [[nodiscard]] bool on() const { return !levels_.empty(); }
  /// Returns an RGBA32F texture with the bloom of the RGBA32F texture `light`. The result has half the size
  /// of `light`, rounded up.
  [[nodiscard]] const gl::Texture& draw(const gl::Texture& light) const;

 private:
  struct Level {
    gl::Texture down, up;
  };
  float threshold_;
  float reach_;
  std::vector<Level> levels_;
  gl::Kernel<BloomFirst> first_;
  gl::Kernel<BloomDown> down_;
  gl::Kernel<BloomUp> up_;
};

}  // namespace simreel::draw
