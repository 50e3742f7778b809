#include "sim/cloth/skin_hold.hpp"

namespace simreel::shader::cloth {
#include "glsl/cloth/bindings.glsl"
}  // namespace simreel::shader::cloth

namespace simreel::sim {

SkinHold::SkinHold(const std::string& name, const SkinPins& pins, const gl::Defines& defines)
    : count_(pins.count()) {
  if (count_ == 0) return;
  ways_ = gl::Vec4Array(name + " ways of pins", 2 * count_);
  program_ = gl::Program::compute("cloth/hold.comp", defines);
  program_.set("count", count_);
}

void SkinHold::beginFrame(const SkinPins& pins, double begin, double end) {
  if (count_ > 0) ways_.write(pins.frame(begin, end));
}

void SkinHold::hold(const gl::Vec4Array& velocities, int substep, int substeps) const {
  if (count_ == 0) return;
  const double now = static_cast<double>(substep + 1) / substeps;
  program_.set("before", static_cast<float>(1.0 - now));
  program_.set("now", static_cast<float>(now));
  velocities.bindState(shader::cloth::velocitiesBinding);
  ways_.bindInput(shader::cloth::waysBinding);
  program_.dispatch(count_);
  gl::barrier();
}

}  // namespace simreel::sim
