#include "draw/screen/readback.hpp"

#include "base/error.hpp"
#include "gl/context.hpp"
#include "gl/errors.hpp"

namespace simreel::draw {

Readback::Readback(glm::ivec2 size)
    : size_(size), bytes_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4) {
  constexpr GLbitfield mapping = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  for (Slot& slot : slots_) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    slot.buffer = gl::Handle<gl::DeleteBuffer>(name);
    const auto bytes = static_cast<GLsizeiptr>(bytes_);
    glNamedBufferStorage(name, bytes, nullptr, mapping | GL_CLIENT_STORAGE_BIT);
    slot.bytes = static_cast<const std::uint8_t*>(glMapNamedBufferRange(name, 0, bytes, mapping));
    if (slot.bytes == nullptr)
      fail(ExitCode::device, "the device has no memory left to copy pictures of {}x{} pixels out", size.x,
           size.y);
    glObjectLabel(GL_BUFFER, name, -1, "readback");
  }
}

Readback::~Readback() {
  for (const Slot& slot : slots_)
    if (slot.done != nullptr) glDeleteSync(slot.done);
}

void Readback::start(const gl::Framebuffer& framebuffer, int tag) {
  SIMREEL_CHECK(!full());
  Slot& slot = slots_[(oldest_ + count_) % slots_.size()];
  // Also binds a draw framebuffer. Without a draw framebuffer and a default framebuffer, NVIDIA's driver
  // 580 copies a hundred times more slowly.
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  glBindBuffer(GL_PIXEL_PACK_BUFFER, slot.buffer.get());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  slot.done = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();  // Without a flush, the fence could wait for commands that have not been sent.
  slot.tag = tag;
  ++count_;
  copyOn();
}

void Readback::copyOn() {
  if (gl::softwareDriver())
    return;  // Software drivers use all processors, so a separate thread would not
             // help.
  for (std::size_t i = 0; i < count_; ++i) {
    Slot& slot = slots_[(oldest_ + i) % slots_.size()];
    if (slot.copies) continue;
    if (!isReady(slot, false)) return;
    slot.copy.from = slot.bytes;
    slot.copy.count = bytes_;
    slot.copies = thread_.start(slot.copy);
  }
}

bool Readback::reached(bool wait) const {
  return !empty() && isReady(slots_[oldest_], wait);
}

bool Readback::isReady(const Slot& slot, bool wait) {
  constexpr GLuint64 second = 1'000'000'000;
  GLenum state = glClientWaitSync(slot.done, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? second : 0);
  while (wait && state == GL_TIMEOUT_EXPIRED) state = glClientWaitSync(slot.done, 0, second);
  if (state == GL_WAIT_FAILED) fail(ExitCode::device, "the device was lost while a picture was copied out");
  return state != GL_TIMEOUT_EXPIRED;
}

std::optional<std::pair<int, std::vector<std::uint8_t>>> Readback::nextPicture(bool wait) {
  if (!reached(wait)) return std::nullopt;
  Slot& slot = slots_[oldest_];
  copyOn();
  std::vector<std::uint8_t> bytes;
  if (slot.copies)
    bytes = thread_.wait(slot.copy);
  else
    bytes.assign(slot.bytes, slot.bytes + bytes_);
  slot.copies = false;
  glDeleteSync(slot.done);
  slot.done = nullptr;
  oldest_ = (oldest_ + 1) % slots_.size();
  --count_;
  gl::checkCalls();
  return std::pair(slot.tag, std::move(bytes));
}

}  // namespace simreel::draw
