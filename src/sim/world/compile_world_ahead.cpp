#include "base/error.hpp"
#include "base/log.hpp"
#include "gl/kernel_compiler.hpp"
#include "gl/rehearsal.hpp"
#include "sim/world/world.hpp"

#include <utility>
#include <vector>

namespace simreel::sim {

// Making a world takes time of its own, which a filled cache would not win back.
void compileWorldAhead(const scene::Scene& scene) {
  if (!gl::KernelCompiler::helps() || !gl::KernelCompiler::isCold()) return;
  gl::Rehearsal rehearsal;
  try {
    const Silence silence;
    World world(scene);
    world.advanceTo(0);
  } catch (const UserError&) {
    // The real world meets it, too, and says so; or there was no end to dispatches.
  }
  gl::KernelCompiler::announce(rehearsal.take());
}

}  // namespace simreel::sim
