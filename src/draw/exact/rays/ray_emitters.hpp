#pragma once
#include "draw/exact/rays/ray_kernels.hpp"
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Triangles that shine by themselves, from which glsl/draw/exact/rays/emitters.glsl chooses.
class RayEmitters {
 public:
  void begin();
  /// Triangles `first` to before `first + count` whose light has that brightness. Waits for the device;
  /// `places` and `corners`: of all triangles, as glsl/draw/exact/rays/gather.comp leaves them.
  void add(const gl::Buffer& places, const gl::Buffer& corners, int first, int count, double brightness);
  void finish();
  /// `places`: as add() had them, as texels.
  [[nodiscard]] EmitterFields fields(const gl::Texture& places) const;

 private:
  struct Part {
    std::uint32_t triangle = 0;
    double light = 0;  ///< m^2 times brightness
  };
  std::vector<Part> parts_;
  double all_ = 0;
  gl::Buffer buffer_;
  gl::Texture view_;
};

}  // namespace simreel::draw
