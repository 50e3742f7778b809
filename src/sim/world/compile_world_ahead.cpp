#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/kernel_compiler.hpp"
#include "gl/rehearsal.hpp"
#include "sim/world/world.hpp"

#include <utility>
#include <vector>

namespace simreel::sim {

// Does nothing if the kernel cache is warm: constructing a World takes time that only saved compilations
// win back.
void compileWorldAhead(const scene::Scene& scene) {
  if (!gl::KernelCompiler::helps() || !gl::KernelCompiler::isCold()) return;
  gl::Rehearsal rehearsal;
  try {
    const Silence silence;
    World world(scene);
    world.advanceTo(0);
  } catch (const UserError&) {
    // The real World meets the same error and reports it. Or the rehearsal was stopped because the
    // dispatches did not end.
  }
  gl::KernelCompiler::announce(rehearsal.extractKernels());
}

}  // namespace simreel::sim
