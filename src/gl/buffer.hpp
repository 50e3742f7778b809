#pragma once
#include "gl/handle.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace simreel::gl {

/// GPU memory of fixed size, passed to kernels as a storage or uniform block. If it exceeds the device's
/// block limit, allocation throws UserError(device) that names the limit. A default-constructed Buffer is
/// empty: its size and name are 0.
class Buffer {
 public:
  Buffer() = default;
  /// Creates a buffer filled with zeros. `label` appears in debug messages and limit errors.
  Buffer(const std::string& label, std::size_t bytes);

  template <class T>
  static Buffer of(const std::string& label, std::span<const T> items) {
    static_assert(std::is_trivially_copyable_v<T>);
    return Buffer(label, items.size_bytes(), items.data());
  }

  /// Creates a buffer that shaders read only through texel views. Texture::view() checks the limit of texel
  /// views; the block limit does not apply.
  template <class T>
  static Buffer ofTexels(const std::string& label, std::span<const T> items) {
    static_assert(std::is_trivially_copyable_v<T>);
    return unchecked(label, items.size_bytes(), items.data());
  }

  /// Creates a zero-filled buffer that kernels access in parts (BufferPart). The buffer may exceed the
  /// device's block limit, but each part must be within the limit.
  static Buffer inParts(const std::string& label, std::size_t bytes);

  /// Creates a buffer that stays persistently and coherently mapped. The mapping is for CPU writes if
  /// `writing` is true, and otherwise for CPU reads. The caller must use fences so that CPU and GPU never
  /// access the same bytes at the same time. The initial contents are undefined.
  static Buffer mapped(const std::string& label, std::size_t bytes, bool writing);
  /// Returns the CPU address of a mapped buffer, or null for other buffers.
  [[nodiscard]] void* memory() const { return memory_; }

  /// Copies bytes into the buffer, in order with other GL commands. To overwrite data that kernels wrote,
  /// call beforeWrites() first.
  void write(std::size_t offset, std::span<const std::byte> bytes);
  /// Waits for the GPU and copies bytes out of the buffer.
  void read(std::size_t offset, std::span<std::byte> bytes) const;
  template <class T>
  [[nodiscard]] std::vector<T> readAll() const {
    std::vector<T> items(bytes_ / sizeof(T));
    read(0, std::as_writable_bytes(std::span(items)));
    return items;
  }
  void bindStorage(GLuint binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name()); }
  void bindUniform(GLuint binding, std::size_t offset, std::size_t bytes) const {
    glBindBufferRange(GL_UNIFORM_BUFFER, binding, name(), static_cast<GLintptr>(offset),
                      static_cast<GLsizeiptr>(bytes));
  }

  [[nodiscard]] GLuint name() const { return handle_.get(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  /// Creates a buffer without checking the block limit. If `items` is null, fills it with zeros.
  static Buffer unchecked(const std::string& label, std::size_t bytes, const void* items);
  Buffer(const std::string& label, std::size_t bytes, const void* items);
  void store(const std::string& label, const void* items);
  [[nodiscard]] bool staged() const;
  void copyStaged(std::size_t offset, const std::byte* items, std::size_t bytes);

  Handle<DeleteBuffer> handle_;
  std::size_t bytes_ = 0;
  void* memory_ = nullptr;  ///< CPU address of the mapping, valid for the buffer's lifetime; null if the
                            ///< buffer is not mapped
};

/// A part of a buffer. The buffer must outlive the part. Kernels can use the part in the same way as a
/// buffer.
struct BufferPart {
  const Buffer* buffer = nullptr;
  std::size_t offset = 0;  ///< offset in bytes, a multiple of `alignment`
  std::size_t bytes = 0;

  /// Alignment of offsets (bytes) that all devices accept for storage blocks and texel views.
  static constexpr std::size_t alignment = 256;
  [[nodiscard]] static std::size_t aligned(std::size_t bytes) {
    return (bytes + alignment - 1) / alignment * alignment;
  }
  void bindStorage(GLuint binding) const {
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, buffer->name(), static_cast<GLintptr>(offset),
                      static_cast<GLsizeiptr>(bytes));
  }
};

/// Waits for the device, so that a later Buffer::write cannot run before the writes of earlier kernels.
void beforeWrites();

}  // namespace simreel::gl
