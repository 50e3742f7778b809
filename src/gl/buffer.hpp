#pragma once
#include "gl/handle.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace simreel::gl {

/// GPU memory of fixed size, which kernels get as a block. Allocation beyond the device's block limit
/// throws UserError(device) naming the limit. An empty Buffer (default constructed) has size 0 and name 0.
class Buffer {
 public:
  Buffer() = default;
  /// `label` shows in debug messages and limit errors. Contents are zero.
  Buffer(const std::string& label, std::size_t bytes);

  template <class T>
  static Buffer of(const std::string& label, std::span<const T> items) {
    static_assert(std::is_trivially_copyable_v<T>);
    return Buffer(label, items.size_bytes(), items.data());
  }

  /// Memory that is only read through texel views: its limit is theirs, which Texture::view() checks.
  template <class T>
  static Buffer ofTexels(const std::string& label, std::span<const T> items) {
    static_assert(std::is_trivially_copyable_v<T>);
    return unchecked(label, items.size_bytes(), items.data());
  }

  /// Of which kernels get parts (BufferPart), each within the device's block limit; zeros.
  static Buffer inParts(const std::string& label, std::size_t bytes);

  /// Memory that stays mapped for the buffer's whole life, coherent, for writing by the CPU (`writing`) or
  /// for reading; whoever uses it keeps away, by fences, from what the GPU is at. Contents are undefined.
  static Buffer mapped(const std::string& label, std::size_t bytes, bool writing);
  /// Of a mapped buffer, else null.
  [[nodiscard]] void* memory() const { return memory_; }

  /// Copies into the buffer, ordered with the GL commands around it; after what kernels wrote there only by
  /// beforeWrites().
  void write(std::size_t offset, std::span<const std::byte> bytes);
  /// Waits for the GPU and copies out.
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
  /// Whatever the size. Null: zeros.
  static Buffer unchecked(const std::string& label, std::size_t bytes, const void* items);
  Buffer(const std::string& label, std::size_t bytes, const void* items);
  void store(const std::string& label, const void* items);
  [[nodiscard]] bool staged() const;
  void copyStaged(std::size_t offset, const std::byte* items, std::size_t bytes);

  Handle<DeleteBuffer> handle_;
  std::size_t bytes_ = 0;
  void* memory_ = nullptr;  ///< as long as the buffer
};

/// A part of a buffer, which outlives it. Kernels get it as if it were one by itself.
struct BufferPart {
  const Buffer* buffer = nullptr;
  std::size_t offset = 0;  ///< bytes, a multiple of `alignment`
  std::size_t bytes = 0;

  /// What every device is content with, of storage blocks and of texel views.
  static constexpr std::size_t alignment = 256;
  [[nodiscard]] static std::size_t aligned(std::size_t bytes) {
    return (bytes + alignment - 1) / alignment * alignment;
  }
  void bindStorage(GLuint binding) const {
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, buffer->name(), static_cast<GLintptr>(offset),
                      static_cast<GLsizeiptr>(bytes));
  }
};

/// What kernels have written so far comes before what Buffer::write writes from now on: waits for the
/// device.
void beforeWrites();

}  // namespace simreel::gl
