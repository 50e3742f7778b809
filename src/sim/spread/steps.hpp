#pragma once
#include "gl/buffer.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace simreel::sim {

/// The uniform blocks of a frame's steps in one buffer; Step has `data`, the block's struct.
template <class Step>
class SpreadSteps {
 public:
  SpreadSteps(const std::string& label, int most) {
    const auto alignment = static_cast<std::size_t>(gl::limits().uniformAlignment);
    stride_ = (sizeof(Step::data) + alignment - 1) / alignment * alignment;
    buffer_ = gl::Buffer(label, stride_ * static_cast<std::size_t>(most));
  }
  void upload(const std::vector<Step>& steps) {
    if (steps.empty()) return;
    std::vector<std::byte> bytes(stride_ * steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
      std::memcpy(&bytes[i * stride_], &steps[i].data, sizeof steps[i].data);
    buffer_.write(0, bytes);
  }
  /// For uniform block 0.
  void bind(std::size_t step) const { buffer_.bindUniform(0, stride_ * step, sizeof(Step::data)); }

 private:
  std::size_t stride_ = 0;
  gl::Buffer buffer_;
};

}  // namespace simreel::sim
