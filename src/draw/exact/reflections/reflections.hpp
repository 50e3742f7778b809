#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <cstddef>

#include <glm/vec2.hpp>

namespace simreel::draw {

struct LevelKernel;

/// What mirrors show of the picture that they are seen in, beside the surroundings
/// (glsl/draw/exact/reflections/mirrored_way.glsl): its light as it is shaded without that, and how near
/// things are, both at half its size, and in levels of half the size of the one before. 8 bytes a pixel.
class Reflections {
 public:
  /// Of pictures with a ground, which is left out of what is near; PARALLEL: seen along parallel rays.
  /// Throws UserError(device) where the device has no such buffers.
  explicit Reflections(glm::ivec2 size, bool ground = false, bool parallel = false);

  /// Takes over the light of a whole picture, and Occlusion::nearness().
  void see(const gl::Texture& light, const gl::Texture& nearness) const;
  /// For kernels that include draw/exact/reflections/reflections_read.glsl: light and nearness, in levels.
  [[nodiscard]] const gl::Texture& light() const { return light_.view; }
  [[nodiscard]] const gl::Texture& nearest() const { return nearest_.view; }
  /// What those are told: how far away what is mirrored may be, and how thick it is (m), where the camera
  /// looks at something `away` (m).
  [[nodiscard]] static glm::vec2 reachOf(float away) { return {away, away / 24.0F}; }

 private:
  /// Of half pixels.
  struct Levels {
    Levels(const char* label, GLenum format, std::size_t bytes, glm::ivec2 half);
    gl::Buffer buffer;
    gl::Texture view;
  };

  glm::ivec2 size_;
  Levels light_, nearest_;
  gl::Kernel<LevelKernel> first_, next_;
};

}  // namespace simreel::draw
