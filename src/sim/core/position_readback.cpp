#include "sim/core/position_readback.hpp"

#include "base/error.hpp"

#include <cstring>

namespace simreel::sim {

bool pollFence(GLsync& fence, bool waiting) {
  if (fence == nullptr) return true;
  constexpr GLuint64 second = 1'000'000'000;
  GLenum state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, waiting ? second : 0);
  while (waiting && state == GL_TIMEOUT_EXPIRED) state = glClientWaitSync(fence, 0, second);
  if (state == GL_WAIT_FAILED) fail(ExitCode::device, "the device was lost while a mesh was deformed");
  if (state == GL_TIMEOUT_EXPIRED) return false;
  glDeleteSync(fence);
  fence = nullptr;
  return true;
}

PositionReadback::PositionReadback(const std::string& label, std::size_t elements) {
  for (Slot& slot : slots_) slot.buffer = gl::Buffer::mapped(label, elements * sizeof(glm::vec4), false);
}

PositionReadback::~PositionReadback() {
  for (const Slot& slot : slots_)
    if (slot.done != nullptr) glDeleteSync(slot.done);
}

bool PositionReadback::takeOldest(bool waiting) {
  if (count_ == 0) return false;
  Slot& slot = slots_[oldest_];
  if (!pollFence(slot.done, waiting)) return false;
  newest_.resize(slot.buffer.bytes() / sizeof(glm::vec4));
  std::memcpy(newest_.data(), slot.buffer.memory(), slot.buffer.bytes());
  oldest_ = (oldest_ + 1) % slots_.size();
  --count_;
  return true;
}

void PositionReadback::start(const gl::Buffer& source) {
  while (takeOldest(false)) {
  }
  current_ = count_ < slots_.size();
  if (!current_) return;
  Slot& slot = slots_[(oldest_ + count_) % slots_.size()];
  SIMREEL_CHECK_EQ(source.bytes(), slot.buffer.bytes());
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(source.name(), slot.buffer.name(), 0, 0,
                           static_cast<GLsizeiptr>(source.bytes()));
  slot.done = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();  // Without a flush, the fence would wait for commands that were never submitted.
  ++count_;
}

const std::vector<glm::vec4>& PositionReadback::newest() {
  while (takeOldest(false)) {
  }
  return newest_;
}

const std::vector<glm::vec4>& PositionReadback::wait() {
  while (takeOldest(true)) {
  }
  return newest_;
}

}  // namespace simreel::sim
