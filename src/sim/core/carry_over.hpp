#pragma once
#include "gl/buffer.hpp"

#include <bit>
#include <concepts>
#include <cstdint>

namespace simreel::sim {

/// What a simulation carries from a frame to the next beyond what scene and time give it. Each simulation
/// names it once, always in the same order; whoever asks reads it or puts it back
/// (frame/file/checkpoint.hpp).
class CarryOver {
 public:
  virtual ~CarryOver() = default;
  /// The whole of a buffer.
  virtual void array(const char* name, gl::Buffer& buffer) = 0;
  template <std::integral Integer>
  void number(const char* name, Integer& value) {
    std::int64_t bits = value;
    word(name, bits);
    value = static_cast<Integer>(bits);
  }
  void number(const char* name, double& value) {
    auto bits = std::bit_cast<std::int64_t>(value);
    word(name, bits);
    value = std::bit_cast<double>(bits);
  }

 protected:
  virtual void word(const char* name, std::int64_t& bits) = 0;
};

}  // namespace simreel::sim
