#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Rectangles in layers: what is painted first, what over it, and so on.
struct BoxLayers {
  std::vector<glm::vec4> boxes;  ///< two each: left, top, right, bottom in whole pixels; encoded colour
  std::vector<int> ends;         ///< of each layer, in rectangles
};
/// The same picture as painting `boxes` in their order: those of a layer do not overlap, or have the same
/// colour. In pieces of at most 16 x 16 pixels, within the picture.
[[nodiscard]] BoxLayers boxLayers(const std::vector<glm::vec4>& boxes, glm::ivec2 picture);

struct PaintBoxes;

/// Rectangles as a kernel paints them over the finished picture; kept until others come.
class BoxList {
 public:
  /// `target`: RGBA8, its first row the picture's top one. Leaves the image to a barrier of the caller.
  void paint(const std::vector<glm::vec4>& boxes, const gl::Texture& target);

 private:
  gl::Kernel<PaintBoxes> kernel_;   ///< made when first needed
  std::vector<glm::vec4> present_;  ///< what the buffer was made of
  BoxLayers layers_;
  gl::Buffer buffer_;
  gl::Texture view_;
};

/// Makes what kernels wrote to an image visible to drawing and to copies.
void imageBarrier();

}  // namespace simreel::draw
