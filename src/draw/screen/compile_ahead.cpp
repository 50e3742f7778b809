#include "base/error.hpp"
#include "base/log.hpp"
#include "draw/screen/renderer.hpp"
#include "gl/kernel_compiler.hpp"
#include "gl/rehearsal.hpp"

#include <utility>
#include <vector>

namespace simreel::draw {

namespace {

/// Returns a smaller picture size for the rehearsal that needs the same kernels. Powers of two remain
/// powers of two, because the machine code depends on them.
glm::ivec2 rehearsedSize(glm::ivec2 size) {
  constexpr int enough = 640 * 400;
  while (size.x * size.y > enough) size = (size + 1) / 2;
  return size;
}

}  // namespace

void compileAhead(const scene::Scene& scene, glm::ivec2 size, int samples, double seconds,
                  const sim::Drawables& drawables, const RendererOptions& options) {
  if (!gl::KernelCompiler::helps()) return;
  if (options.rasterizer.value_or(scene.render.rasterizer) != scene::Rasterizer::exact) return;
  std::vector<gl::Rehearsal::Kernel> kernels;
  try {
    const Silence silence;
    gl::Rehearsal rehearsal;
    Renderer renderer(scene, rehearsedSize(size), samples, options);
    renderer.draw(seconds, drawables);
    kernels = rehearsal.extractKernels();
  } catch (const UserError&) {
    return;  // the real picture will fail in the same way and report the error
  }
  gl::KernelCompiler::announce(std::move(kernels));
}

}  // namespace simreel::draw
