#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/cloth/skin_pins.hpp"

#include <string>

namespace simreel::sim {

struct HoldKernel;

/// Pins that follow a skin, on the GPU. Nothing where there are none.
class SkinHold {
 public:
  SkinHold() = default;
  SkinHold(const std::string& name, const SkinPins& pins, const gl::Defines& defines);
  /// The frame from `begin` to `end` (s).
  void beginFrame(const SkinPins& pins, double begin, double end);
  /// Leaves in `velocities` where they go in a substep of so many.
  void hold(const gl::Vec4Array& velocities, int substep, int substeps) const;

 private:
  int count_ = 0;
  gl::Vec4Array ways_;
  gl::Kernel<HoldKernel> kernel_;
};

}  // namespace simreel::sim
