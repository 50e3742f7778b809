#include "sim/cloth/skin_hold.hpp"

namespace simreel::sim {

struct HoldKernel {
  static constexpr auto file = "cloth/hold.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"before", float> before;
  gl::Uniform<"now", float> now;
  gl::In<"ways"> ways;
  gl::InOut<"velocities"> velocities;
};

SkinHold::SkinHold(const std::string& name, const SkinPins& pins, const gl::Defines& defines)
    : count_(pins.count()) {
  if (count_ == 0) return;
  ways_ = gl::Vec4Array(name + " ways of pins", 2 * count_);
  kernel_ = gl::Kernel<HoldKernel>(defines);
}

void SkinHold::beginFrame(const SkinPins& pins, double begin, double end) {
  if (count_ > 0) ways_.write(pins.frame(begin, end));
}

void SkinHold::hold(const gl::Vec4Array& velocities, int substep, int substeps) const {
  if (count_ == 0) return;
  const double now = static_cast<double>(substep + 1) / substeps;
  kernel_.dispatch(count_, {.count = count_,
                            .before = static_cast<float>(1.0 - now),
                            .now = static_cast<float>(now),
                            .ways = ways_,
                            .velocities = velocities});
}

}  // namespace simreel::sim
