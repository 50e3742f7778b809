#include "sim/particles_pairs.hpp"

#include "gl/context.hpp"
#include "sim/particles_plan.hpp"

#include <algorithm>

namespace simreel::sim {

PairGravity::PairGravity(bool fast)
    : pairs_(gl::Program::compute("particles/accelerate.comp", gl::kernelDefines(fast))) {
  splitAfter(gl::softwareDriver() ? 32768 : 1 << 24);
}

void PairGravity::splitAfter(int bodies) {
  bodiesPerDispatch_ = ((std::max(bodies, 1) - 1) / shader::chunkBodies + 1) * shader::chunkBodies;
}

void PairGravity::accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                             float gravity, float softening) const {
  accelerate(positions, accelerations, count, gravity, softening, {0, count});
}

void PairGravity::accelerate(const gl::Vec4Array& positions, const gl::Vec4Array& accelerations, int count,
                             float gravity, float softening, glm::ivec2 targets) const {
  constexpr int targetsPerTexelInvocation = 8;
  positions.bindInput(0);
  accelerations.bindState(1);
  pairs_.set("targets", targets);
  pairs_.set("factors", glm::vec2(softening * softening, gravity));
  const int invocations = gl::memoryPath() == gl::MemoryPath::texel
                              ? (targets.y - targets.x - 1) / targetsPerTexelInvocation + 1
                              : targets.y - targets.x;
  for (int first = 0; first < count; first += bodiesPerDispatch_) {
    const int end = std::min(count - first, bodiesPerDispatch_) + first;
    pairs_.set("bodies", glm::ivec2(first, end));
    pairs_.set("continued", first > 0 ? 1 : 0);
    pairs_.set("last", end == count ? 1 : 0);
    gl::barrier();
    pairs_.dispatch(invocations);
  }
  gl::barrier();
}

}  // namespace simreel::sim
