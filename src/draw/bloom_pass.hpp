#pragma once
#include "draw/draw_state.hpp"
#include "draw/targets.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Light that lenses scatter around what is bright: the scene's light above a threshold through a chain of
/// ever smaller pictures, then up again. Nothing is made and nothing runs when the scene has no bloom.
class BloomPass {
 public:
  BloomPass(const scene::Bloom& bloom, glm::ivec2 size, int samples);
  [[nodiscard]] bool on() const { return on_; }
  /// Scattered light of targets.light, half its size, of the same total; needs on().
  const gl::Texture& draw(const Targets& targets) const;

 private:
  struct Level {
    gl::Texture down, up;
    gl::Framebuffer downTarget, upTarget;
  };
  bool on_;
  float threshold_;
  float reach_;  ///< levels that share the light, the last one in part
  gl::Program first_, down_, up_;
  std::vector<Level> levels_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
