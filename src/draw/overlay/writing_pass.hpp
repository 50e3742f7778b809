#pragma once
#include "draw/overlay/coverage.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

struct WritingKernel;

/// Draws text over the finished picture: how much letters cover of each pixel is found on the CPU when it
/// changes, which is exact and the same on every machine, and a kernel lays it over.
class WritingPass {
 public:
  explicit WritingPass(glm::ivec2 picture) : picture_(picture) {}
  /// Over an RGBA8 picture, its first row the top one. Whoever reads it then needs a barrier.
  void draw(const sim::Drawables& drawables, const gl::Texture& picture);

 private:
  struct Kept {
    std::vector<std::vector<glm::dvec2>> polygons;
    Coverage coverage;
    gl::Buffer shares;
    gl::Texture view;
  };
  void cover(const sim::Writing& writing, Kept& kept) const;

  glm::ivec2 picture_;
  gl::Kernel<WritingKernel> kernel_;
  std::vector<Kept> kept_;
};

}  // namespace simreel::draw
