#pragma once
#include "draw/exact/rays/ray_kernels.hpp"
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Emitting triangles, from which glsl/draw/exact/rays/emitters.glsl draws light samples.
class RayEmitters {
 public:
  void begin();
  /// Adds the triangles from `first` to first + count - 1. Waits for the GPU. `places` and `corners`:
  /// buffers of all triangles, as written by glsl/draw/exact/rays/gather.comp. `brightness`: emission of
  /// the triangles.
  void add(const gl::Buffer& places, const gl::Buffer& corners, int first, int count, double brightness);
  void finish();
  /// Returns the shader inputs of the emitters. `places`: texel view of the buffer passed to add().
  [[nodiscard]] EmitterFields fields(const gl::Texture& places) const;

 private:
  struct Part {
    std::uint32_t triangle = 0;
    double light = 0;  ///< emitted light: area (m^2) times brightness
  };
  std::vector<Part> parts_;
  double all_ = 0;
  gl::Buffer buffer_;
  gl::Texture view_;
};

}  // namespace simreel::draw
