#include "sim/particles/pairs.hpp"

#include "gl/context.hpp"
#include "sim/particles/plan.hpp"

#include <algorithm>
#include <string>

namespace simreel::shader::particles {
#include "glsl/particles/bindings.glsl"
}

namespace simreel::sim {

namespace {

constexpr int targetsPerTexelInvocation = 8;
constexpr int manyTargets = 4;

gl::Program makeProgram(bool fast, int targets) {
  gl::Defines defines = gl::kernelDefines(fast);
  defines.emplace_back("TARGETS", std::to_string(targets));
  return gl::Program::compute("particles/accelerate.comp", defines);
}

}  // namespace

PairGravity::PairGravity(bool fast) : pairs_(makeProgram(fast, 1)) {
  if (gl::memoryPath() == gl::MemoryPath::storage) manyPairs_ = makeProgram(fast, manyTargets);
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
  const gl::Program& program = many ? manyPairs_ : pairs_;
  const int each = texel ? targetsPerTexelInvocation : many ? manyTargets : 1;
  positions.bindInput(shader::particles::positionsBinding);
  accelerations.bindState(shader::particles::accelerationsBinding);
  program.set("targets", targets);
  program.set("softeningSquared", softening * softening);
  program.set("gravity", gravity);
  for (int first = 0; first < count; first += bodiesPerDispatch_) {
    const int end = std::min(count - first, bodiesPerDispatch_) + first;
    program.set("bodies", glm::ivec2(first, end));
    program.set("continued", first > 0 ? 1 : 0);
    program.set("last", end == count ? 1 : 0);
    gl::barrier();
    program.dispatch((wanted - 1) / each + 1);
  }
  gl::barrier();
}

}  // namespace simreel::sim
