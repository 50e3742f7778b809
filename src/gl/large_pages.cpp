#include "gl/large_pages.hpp"

#include "base/error.hpp"
#include "gl/vulkan_memory.hpp"

#include <cstdlib>
#include <string_view>

namespace simreel::gl {

namespace {

/// Returns the Vulkan memory of the current context's device. Returns null if the device has none or if
/// OpenGL cannot import memory.
const VulkanMemory* memoryOfDevice() {
  static const VulkanMemory* const memory = []() -> const VulkanMemory* {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
    const char* asked = std::getenv("SIMREEL_LARGE_PAGES");
    const std::string_view wanted = asked != nullptr ? asked : "yes";
    if (wanted != "yes" && wanted != "no")
      fail(ExitCode::usage, "SIMREEL_LARGE_PAGES must be \"yes\" or \"no\", not \"{}\"", wanted);
    if (wanted == "no") return nullptr;
    if (!epoxy_has_gl_extension("GL_EXT_memory_object_fd")) return nullptr;
    VulkanMemory::Uuid device{};
    glGetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, device.data());
    // Never freed, because buffers that use the memory may outlive all objects in this file.
    return VulkanMemory::of(device).release();
  }();
  return memory;
}

}  // namespace

bool storeInLargePages(GLuint buffer, std::size_t bytes) {
  const VulkanMemory* memory = memoryOfDevice();
  if (memory == nullptr) return false;
  constexpr std::size_t page = 1 << 16;
  const std::size_t whole = (bytes + page - 1) / page * page;
  const int file = memory->exportMemory(whole);
  if (file < 0) return false;
  GLuint lent = 0;
  glCreateMemoryObjectsEXT(1, &lent);
  glImportMemoryFdEXT(lent, whole, GL_HANDLE_TYPE_OPAQUE_FD_EXT, file);  // OpenGL closes `file`
  glNamedBufferStorageMemEXT(buffer, static_cast<GLsizeiptr>(bytes), lent, 0);
  glDeleteMemoryObjectsEXT(1, &lent);  // the buffer keeps the memory
  GLint immutable = 0;
  glGetNamedBufferParameteriv(buffer, GL_BUFFER_IMMUTABLE_STORAGE, &immutable);
  return immutable != 0;
}

}  // namespace simreel::gl
