#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/resource.hpp"
#include "gl/limits.hpp"
#include "glsl/common/cpp.hpp"

#include <cstddef>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace simreel::sim {

/// Buffer with one uniform block for each step of a frame, written once per frame.
template <class Block>
class StepBlocks {
 public:
  StepBlocks() = default;
  /// Allocates space for `count` steps.
  StepBlocks(const std::string& label, int count) {
    const auto alignment = static_cast<std::size_t>(gl::limits().uniformAlignment);
    stride_ = (sizeof(Block) + alignment - 1) / alignment * alignment;
    buffer_ = gl::Buffer(label, stride_ * static_cast<std::size_t>(count));
  }
  /// Uploads the blocks of all steps. `blockOf` returns the uniform block of a step, for step types that
  /// hold more than the block.
  template <class Step, class BlockOf = std::identity>
  void upload(const std::vector<Step>& steps, BlockOf blockOf = {}) {
    if (steps.empty()) return;
    std::vector<std::byte> bytes(stride_ * steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Block& block = std::invoke(blockOf, steps[i]);
      std::memcpy(&bytes[i * stride_], &block, sizeof block);
    }
    buffer_.write(0, bytes);
  }
  /// Returns the uniform block of a step as a gl::Kernel resource.
  [[nodiscard]] gl::Resource at(std::size_t step) const { return {buffer_, stride_ * step, sizeof(Block)}; }
  void bind(std::size_t step, GLuint binding = shader::stepBinding) const {
    buffer_.bindUniform(binding, stride_ * step, sizeof(Block));
  }

 private:
  std::size_t stride_ = 0;
  gl::Buffer buffer_;
};

}  // namespace simreel::sim
