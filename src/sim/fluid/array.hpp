#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/resource.hpp"
#include "gl/texture.hpp"

#include <string>

namespace simreel::sim {

/// An array of a fluid's cells as its kernels get it: INPUT_ARRAY and STATE_ARRAY of
/// glsl/common/memory.glsl, or the planes of glsl/fluid/grid.glsl.
class FluidArray {
 public:
  FluidArray() = default;
  FluidArray(const std::string& label, const gl::BufferPart& part);
  /// For a gl::Kernel.
  [[nodiscard]] gl::Resource resource() const { return {part_, texels_}; }
  /// As words, for Field.
  [[nodiscard]] const gl::Texture& words() const { return words_; }
  [[nodiscard]] const gl::BufferPart& part() const { return part_; }

 private:
  gl::BufferPart part_;
  gl::Texture words_, texels_;  ///< texels where there is no other way to read
};

}  // namespace simreel::sim
