#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Rectangles sorted into layers. The layers are painted from the first to the last.
struct BoxLayers {
  std::vector<glm::vec4> boxes;  ///< two entries per rectangle: the edges (left, top, right, bottom) in
                                 ///< whole pixels, then the sRGB-encoded colour
  std::vector<int> ends;         ///< for each layer, the index after its last rectangle
};
/// Sorts rectangles into layers that give the same picture as painting `boxes` in order. Rectangles of one
/// layer do not overlap unless they have the same colour. The rectangles are split into pieces of at most
/// 16 x 16 pixels and clipped to the picture.
[[nodiscard]] BoxLayers boxLayers(const std::vector<glm::vec4>& boxes, glm::ivec2 picture);

struct PaintBoxes;

/// Paints rectangles over the finished picture with a kernel. Uploads the rectangles only when they change.
class BoxList {
 public:
  /// `target`: RGBA8, first row at the top. The caller must call imageBarrier() afterwards.
  void paint(const std::vector<glm::vec4>& boxes, const gl::Texture& target);

 private:
  gl::Kernel<PaintBoxes> kernel_;   ///< created on first use
  std::vector<glm::vec4> present_;  ///< rectangles that the buffer currently holds
  BoxLayers layers_;
  gl::Buffer buffer_;
  gl::Texture view_;
};

/// Issues a memory barrier that makes image writes of kernels visible to drawing and copies.
void imageBarrier();

}  // namespace simreel::draw
