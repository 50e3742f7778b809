#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/resource.hpp"
#include "gl/texture.hpp"

#include <string>

namespace simreel::sim {

/// Array of a fluid's cells, with the views that kernels use: INPUT_ARRAY and STATE_ARRAY of
/// glsl/common/memory.glsl, or the planes of glsl/fluid/grid.glsl.
class FluidArray {
 public:
  FluidArray() = default;
  FluidArray(const std::string& label, const gl::BufferPart& part);
  /// Returns the array as a resource of a gl::Kernel.
  [[nodiscard]] gl::Resource resource() const { return {part_, texels_}; }
  /// Returns a view of the array as 32-bit words, for Field.
  [[nodiscard]] const gl::Texture& words() const { return words_; }
  [[nodiscard]] const gl::BufferPart& part() const { return part_; }

 private:
  gl::BufferPart part_;
  gl::Texture words_,
      texels_;  ///< Views of the array: as 32-bit words and, on the texel path only, as RGBA32F texels.
};

}  // namespace simreel::sim
