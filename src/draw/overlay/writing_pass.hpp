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

/// Draws text over the finished picture. The CPU computes the exact coverage of each pixel when the text
/// changes, with the same result on every machine. A kernel blends the text over the picture.
class TextPass {
 public:
  explicit TextPass(glm::ivec2 picture) : picture_(picture) {}
  /// Draws over an RGBA8 picture whose first row is the top row. The caller must issue a barrier before the
  /// picture is read.
  void draw(const sim::Drawables& drawables, const gl::Texture& picture);

 private:
  struct Cached {
    std::vector<std::vector<glm::dvec2>> polygons;
    Coverage coverage;
    gl::Buffer shares;
    gl::Texture view;
  };
  void cover(const sim::Writing& writing, Cached& cached) const;

  glm::ivec2 picture_;
  gl::Kernel<WritingKernel> kernel_;
  std::vector<Cached> cached_;
};

}  // namespace simreel::draw
