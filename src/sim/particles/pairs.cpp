#include "sim/particles/pairs.hpp"

#include "gl/context.hpp"
#include "sim/particles/plan.hpp"

#include <algorithm>

namespace simreel::sim {

struct PairKernel {
  static constexpr auto file = "particles/accelerate.comp";
  struct Variant {
    gl::Choice<"TARGETS", 1, 4> targets;
  };
  gl::Uniform<"targets", glm::ivec2> targets;
  gl::Uniform<"bodies", glm::ivec2> bodies;
  gl::Uniform<"softeningSquared", float> softeningSquared;
  gl::Uniform<"gravity", float> gravity;
  gl::Uniform<"continued", bool> continued;
  gl::Uniform<"last", bool> last;
  gl::In<"positions"> positions;
  gl::InOut<"accelerations"> accelerations;
};

namespace {

constexpr int targetsPerTexelInvocation = 8;
constexpr int manyTargets = 4;

}  // namespace

PairGravity::PairGravity(bool fast) : pairs_(gl::kernelDefines(fast), {.targets = 1}) {
  if (gl::memoryPath() == gl::MemoryPath::storage)
    manyPairs_ = gl::Kernel<PairKernel>(gl::kernelDefines(fast), {.targets = manyTargets});
  splitAfter(gl::softwareDriver() ? 32768 : 1 << 24);
}

void PairGravity::useManyFrom(int targets) {
  manyFrom_ = targets;
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
  const int wanted = targets.y - targets.x;
  const bool texel = gl::memoryPath() == gl::MemoryPath::texel;
  const bool many = !texel && wanted >= manyFrom_;
  const gl::Kernel<PairKernel>& kernel = many ? manyPairs_ : pairs_;
  const int each = texel ? targetsPerTexelInvocation : many ? manyTargets : 1;
  for (int first = 0; first < count; first += bodiesPerDispatch_) {
    const int end = std::min(count - first, bodiesPerDispatch_) + first;
    kernel.dispatch((wanted - 1) / each + 1, {.targets = targets,
                                              .bodies = glm::ivec2(first, end),
                                              .softeningSquared = softening * softening,
                                              .gravity = gravity,
                                              .continued = first > 0,
                                              .last = end == count,
                                              .positions = positions,
                                              .accelerations = accelerations});
  }
}

}  // namespace simreel::sim
