#include "sim/kernels/pace.hpp"

#include "base/frame_check.hpp"

namespace simreel::sim {

DispatchPace::~DispatchPace() {
  if (before_ != nullptr) glDeleteSync(before_);
}

void DispatchPace::dispatched() {
  checkFrame();
  if (++count_ % atOnce != 0) return;
  constexpr GLuint64 patience = 100'000'000;  // time in ns between two checks for signals
  if (before_ != nullptr) {
    while (glClientWaitSync(before_, GL_SYNC_FLUSH_COMMANDS_BIT, patience) == GL_TIMEOUT_EXPIRED)
      checkFrame();
    glDeleteSync(before_);
  }
  before_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

}  // namespace simreel::sim
