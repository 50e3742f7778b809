#include "gl/buffer.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <vector>

namespace simreel::gl {

namespace {

GLuint createBuffer() {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  return name;
}

void checkBlock(const std::string& label, std::size_t bytes) {
  const auto most = static_cast<std::size_t>(limits().storageBlockBytes);
  if (bytes > most)
    fail(ExitCode::device,
         "{} needs {} bytes, this device allows {} in one buffer (GL_MAX_SHADER_STORAGE_BLOCK_SIZE); make "
         "it smaller",
         label, bytes, most);
}

}  // namespace

// Zeros come as data, not through glClearNamedBufferData: with NVIDIA's driver 580 a clear overtakes a
// large glNamedBufferSubData issued after it.
Buffer::Buffer(const std::string& label, std::size_t bytes)
    : Buffer(label, bytes, std::vector<std::byte>(std::max<std::size_t>(bytes, 1)).data()) {}

Buffer::Buffer(const std::string& label, std::size_t bytes, const void* items)
    : handle_(createBuffer()), bytes_(bytes) {
  checkBlock(label, bytes);
  while (glGetError() != GL_NO_ERROR) {
  }
  glNamedBufferStorage(name(), static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 1)),
                       bytes == 0 ? nullptr : items, GL_DYNAMIC_STORAGE_BIT);
  if (glGetError() == GL_OUT_OF_MEMORY)
    fail(ExitCode::device, "the device has no memory left for {} ({} bytes); make it smaller", label,
         bytes);
  glObjectLabel(GL_BUFFER, name(), -1, label.c_str());
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
  glNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                       bytes.data());
}

void Buffer::read(std::size_t offset, std::span<std::byte> bytes) const {
  SIMREEL_CHECK(offset + bytes.size() <= bytes_);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()),
                          bytes.data());
}

}  // namespace simreel::gl
