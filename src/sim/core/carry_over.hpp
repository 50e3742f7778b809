#pragma once
#include "gl/buffer.hpp"

#include <bit>
#include <concepts>
#include <cstdint>

namespace simreel::sim {

/// Visitor over the simulation data that the next frame depends on and that scene and time do not
/// determine. A simulation visits its data in the same order every time; a derived class reads each item or
/// restores it (frame/file/checkpoint.hpp).
class CarryOver {
 public:
  virtual ~CarryOver() = default;
  /// Visits the whole contents of a buffer.
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
