#include "gl/buffer.hpp"

#include "base/error.hpp"
#include "gl/context.hpp"
#include "gl/errors.hpp"
#include "gl/large_pages.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <vector>

namespace simreel::gl {

namespace {

/// directBytes: max size of a buffer that the CPU writes directly. stagedBytes: size of one staged copy
/// into a larger buffer.
constexpr std::size_t directBytes = 4 << 20, stagedBytes = 64 << 20;
/// Min size (bytes) of a buffer for which large pages are requested, because address lookups (TLB misses)
/// slow down large buffers.
constexpr std::size_t largePagesBytes = 32 << 20;

GLuint createBuffer() {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  return name;
}

void checkBlock(const std::string& label, std::size_t bytes) {
  const auto max = static_cast<std::size_t>(limits().storageBlockBytes);
  if (bytes > max)
    fail(ExitCode::device,
         "{} needs {} bytes, this device allows {} in one buffer (GL_MAX_SHADER_STORAGE_BLOCK_SIZE); make "
         "it smaller",
         label, bytes, max);
}

}  // namespace

Buffer::Buffer(const std::string& label, std::size_t bytes) : Buffer(label, bytes, nullptr) {}

Buffer::Buffer(const std::string& label, std::size_t bytes, const void* items)
    : handle_(createBuffer()), bytes_(bytes) {
  checkBlock(label, bytes);
  store(label, items);
}

Buffer Buffer::inParts(const std::string& label, std::size_t bytes) {
  return unchecked(label, bytes, nullptr);
}

Buffer Buffer::unchecked(const std::string& label, std::size_t bytes, const void* items) {
  Buffer buffer;
  buffer.handle_ = Handle<DeleteBuffer>(createBuffer());
  buffer.bytes_ = bytes;
  buffer.store(label, items);
  return buffer;
}

void Buffer::store(const std::string& label, const void* items) {
  const std::size_t bytes = bytes_;
  checkCalls();
  // Zeros are uploaded as data instead of with glClearNamedBufferData, because NVIDIA's driver 580 may run
  // a clear before an earlier large glNamedBufferSubData.
  const bool zero = items == nullptr || bytes == 0;
  const bool cleared = zero && softwareDriver();
  const std::vector<std::byte> zeros(zero && !cleared ? std::clamp<std::size_t>(bytes, 1, stagedBytes) : 0);
  if (cleared) {
    glNamedBufferStorage(name(), static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 1)), nullptr,
                         GL_DYNAMIC_STORAGE_BIT);
    glClearNamedBufferData(name(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
  } else if (!staged())
    glNamedBufferStorage(name(), static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 1)),
                         zero ? zeros.data() : items, GL_DYNAMIC_STORAGE_BIT);
  else {
    if (bytes < largePagesBytes || !storeInLargePages(name(), bytes))
      glNamedBufferStorage(name(), static_cast<GLsizeiptr>(bytes), nullptr, 0);
    for (std::size_t at = 0; at < bytes; at += stagedBytes)
      copyStaged(at, zero ? zeros.data() : static_cast<const std::byte*>(items) + at,
                 std::min(stagedBytes, bytes - at));
  }
  if (glGetError() == GL_OUT_OF_MEMORY)
    fail(ExitCode::device, "the device has no memory left for {} ({} bytes); make it smaller", label,
         bytes);
  glObjectLabel(GL_BUFFER, name(), -1, label.c_str());
}

// Returns true if the buffer is written through a staging buffer, which is the case for large buffers.
// NVIDIA's driver 580 keeps a second copy of a large buffer that the CPU may write, and kernels on 1 GiB of
// such buffers sometimes ran at a third of their speed. This never happened with buffers that only the GPU
// accesses. With a software driver, a staging buffer would not help: it is in the same memory, and touching
// its pages for the first time would take much of a short run.
bool Buffer::staged() const {
  return bytes_ > directBytes && memory_ == nullptr && !softwareDriver();
}

void Buffer::copyStaged(std::size_t offset, const std::byte* items, std::size_t bytes) {
  const Handle<DeleteBuffer> staging(createBuffer());
  glNamedBufferStorage(staging.get(), static_cast<GLsizeiptr>(bytes), items, GL_CLIENT_STORAGE_BIT);
  glCopyNamedBufferSubData(staging.get(), name(), 0, static_cast<GLintptr>(offset),
                           static_cast<GLsizeiptr>(bytes));
}

Buffer Buffer::mapped(const std::string& label, std::size_t bytes, bool writing) {
  checkBlock(label, bytes);
  const GLbitfield mapping =
      GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT | (writing ? GL_MAP_WRITE_BIT : GL_MAP_READ_BIT);
  Buffer buffer;
  buffer.handle_ = Handle<DeleteBuffer>(createBuffer());
  buffer.bytes_ = bytes;
  glNamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 1)), nullptr,
                       mapping | (writing ? 0U : GL_CLIENT_STORAGE_BIT));
  buffer.memory_ = glMapNamedBufferRange(buffer.name(), 0,
                                         static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 1)), mapping);
  if (buffer.memory_ == nullptr)
    fail(ExitCode::device, "the device has no memory left for {} ({} bytes); make it smaller", label,
         bytes);
  glObjectLabel(GL_BUFFER, buffer.name(), -1, label.c_str());
  return buffer;
}

void Buffer::write(std::size_t offset, std::span<const std::byte> bytes) {
  SIMREEL_CHECK(offset + bytes.size() <= bytes_);
  if (!staged())
    glNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                         bytes.data());
  else
    for (std::size_t at = 0; at < bytes.size(); at += stagedBytes)
      copyStaged(offset + at, bytes.data() + at, std::min(stagedBytes, bytes.size() - at));
}

void Buffer::read(std::size_t offset, std::span<std::byte> bytes) const {
  SIMREEL_CHECK(offset + bytes.size() <= bytes_);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                          bytes.data());
  checkCalls();
}

// glFinish is needed because NVIDIA's driver 580 may run a large glNamedBufferSubData before earlier
// dispatches that write to the same buffer, in spite of GL_BUFFER_UPDATE_BARRIER_BIT.
void beforeWrites() {
  glFinish();
}

}  // namespace simreel::gl
