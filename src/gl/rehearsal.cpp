#include "gl/rehearsal.hpp"

#include "base/error.hpp"
#include "gl/linked_program.hpp"
#include "gl/texture.hpp"

#include <algorithm>

namespace simreel::gl {

namespace {

Rehearsal* current = nullptr;

}  // namespace

Rehearsal::Rehearsal() {
  SIMREEL_CHECK(current == nullptr);
  current = this;
}

Rehearsal::~Rehearsal() {
  current = nullptr;
}

bool Rehearsal::now() {
  return current != nullptr;
}

bool Rehearsal::note(const std::shared_ptr<LinkedProgram>& program) {
  return current != nullptr && note(program, current->bound_);
}

bool Rehearsal::note(const std::shared_ptr<LinkedProgram>& program, const BoundViews& given) {
  if (current == nullptr) return false;
  // Stops a loop that waits for a kernel's result, because kernels do not run in a rehearsal.
  constexpr int maximum = 20000;
  if (++current->noted_ > maximum)
    fail(ExitCode::device, "internal error: a compile-ahead run recorded more than {} dispatches", maximum);
  if (program->linked()) return true;
  auto& kernels = current->kernels_;
  auto found = std::find_if(kernels.begin(), kernels.end(),
                            [&](const Kernel& kernel) { return kernel.program == program; });
  if (found == kernels.end()) found = kernels.insert(kernels.end(), {program, {}});
  // Max number of recorded dispatches per kernel. Later dispatches mostly have the same bindings.
  constexpr std::size_t maxUses = 4;
  if (found->uses.size() < maxUses) found->uses.push_back(given);
  return true;
}

const BoundViews& Rehearsal::bound() {
  SIMREEL_CHECK(current != nullptr);
  return current->bound_;
}

void Rehearsal::bound(GLuint unit, const Texture& texture) {
  if (current != nullptr) current->bound_.textures[unit] = texture.shape();
}

void Rehearsal::boundImage(GLuint unit, const Texture& texture, GLint level, GLenum access, GLenum format) {
  if (current != nullptr) current->bound_.images[unit] = {texture.shape(), level, access, format};
}

}  // namespace simreel::gl
