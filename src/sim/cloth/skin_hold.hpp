#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/cloth/skin_pins.hpp"

#include <string>

namespace simreel::sim {

struct HoldKernel;

/// GPU part of pins that follow a body's skin. Does nothing if a cloth has no such pins.
class SkinHold {
 public:
  SkinHold() = default;
  SkinHold(const std::string& name, const SkinPins& pins, const gl::Defines& defines);
  /// Uploads the pin positions of the frame from time `begin` to `end` (seconds).
  void beginFrame(const SkinPins& pins, double begin, double end);
  /// Writes the target positions of the pinned particles in substep number `substep` of `substeps` into
  /// `velocities`.
  void hold(const gl::Vec4Array& velocities, int substep, int substeps) const;

 private:
  int count_ = 0;
  gl::Vec4Array ways_;
  gl::Kernel<HoldKernel> kernel_;
};

}  // namespace simreel::sim
