#pragma once
#include "draw/screen/screen_program.hpp"
#include "scene/scene.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Light that lenses scatter around what is bright: the scene's light above a threshold through a chain of
/// ever smaller pictures, then up again. Nothing is made and nothing runs when the scene has no bloom.
class BloomPass {
 public:
  /// `samples`: of the light that draw() gets.
  BloomPass(const scene::Bloom& bloom, glm::ivec2 size, int samples);
  [[nodiscard]] bool on() const { return on_; }
  /// Scattered light of a scene's light, half its size, of the same total; needs on().
  const gl::Texture& draw(const gl::Texture& light) const;

 private:
  struct Level {
    ScreenTarget down, up;
  };
  bool on_;
  float threshold_;
  float reach_;  ///< levels that share the light, the last one in part
  ScreenProgram first_, down_, up_;
  std::vector<Level> levels_;
};

}  // namespace simreel::draw
