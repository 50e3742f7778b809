#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/kernel_compiler.hpp"
#include "gl/rehearsal.hpp"
#include "sim/world/world.hpp"

#include <utility>
#include <vector>

namespace simreel::sim {

// If the kernel cache is warm, this does nothing: constructing a World takes time, which only pays off if
// compilation time is saved.
void compileWorldAhead(const scene::Scene& scene) {
  if (!gl::KernelCompiler::helps() || !gl::KernelCompiler::isCold()) return;
  gl::Rehearsal rehearsal;
  try {
    const Silence silence;
    World world(scene);
    world.advanceTo(0);
  } catch (const UserError&) {
    // Either the real World meets the same error and reports it, or the rehearsal was stopped because the
    // dispatches did not end.
  }
  gl::KernelCompiler::announce(rehearsal.extractKernels());
}

}  // namespace simreel::sim
