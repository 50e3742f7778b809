#pragma once
#include "gl/access_log.hpp"
#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "gl/shader_source.hpp"
#include "gl/texture.hpp"

#include <span>
#include <string>
#include <utility>

#include <glm/vec4.hpp>

namespace simreel::gl {

/// Simulation state in elements of 16 bytes, accessible as a storage block and as texels. The bind
/// functions match the declarations in glsl/common/memory.glsl (vec4) and words.glsl (uvec4) for the
/// current memory path.
template <class Element, GLenum format>
class ElementArray {
 public:
  ElementArray() = default;
  /// Creates `count` zero elements.
  ElementArray(const std::string& label, int count)
      : ElementArray(label, Buffer(label, static_cast<std::size_t>(count) * sizeof(Element))) {}
  ElementArray(const std::string& label, std::span<const Element> items)
      : ElementArray(label, Buffer::of(label, items)) {}
  /// Wraps an existing buffer, whose size must be a multiple of the element size.
  ElementArray(const std::string& label, Buffer buffer)
      : buffer_(std::move(buffer)), view_(Texture::view(label, format, buffer_)) {}

  /// Binds the array for INPUT_ARRAY(unit, ...) and INPUT_WORDS.
  void bindInput(GLuint unit) const {
    if (memoryPath() == MemoryPath::texel)
      view_.bind(unit);
    else
      buffer_.bindStorage(unit);
  }
  /// Binds the array for STATE_ARRAY(unit, ...) and STATE_WORDS.
  void bindState(GLuint unit) const {
    if (memoryPath() == MemoryPath::texel) {
      view_.bindImage(unit, GL_READ_ONLY);
      view_.bind(unit);
    }
    buffer_.bindStorage(unit);
  }

  /// Copies all elements of an array of the same size, in order with other GL commands.
  void copyFrom(const ElementArray& other) {
    glCopyNamedBufferSubData(other.buffer_.name(), buffer_.name(), 0, 0,
                             static_cast<GLsizeiptr>(buffer_.bytes()));
  }
  /// Copies `items` to the start of the array, in order with other GL commands.
  void write(std::span<const Element> items) { buffer_.write(0, std::as_bytes(items)); }
  [[nodiscard]] const Buffer& buffer() const { return buffer_; }
  [[nodiscard]] Buffer& buffer() { return buffer_; }
  [[nodiscard]] const Texture& view() const { return view_; }

 private:
  static_assert(sizeof(Element) == 16);
  Buffer buffer_;
  Texture view_;
};

using Vec4Array = ElementArray<glm::vec4, GL_RGBA32F>;
using WordsArray = ElementArray<glm::uvec4, GL_RGBA32UI>;

/// Makes writes of earlier dispatches visible to later dispatches and draws, and to the accesses in `more`
/// (bits of glMemoryBarrier).
inline void barrier(GLbitfield more = 0) {
  AccessLog::barrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                     GL_TEXTURE_FETCH_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT | more);
}

/// Returns the defines that select the memory path. If `fast` is true, adds the define for built-in (not
/// bit-reproducible) arithmetic.
inline Defines kernelDefines(bool fast) {
  Defines defines;
  if (memoryPath() == MemoryPath::texel) defines.emplace_back("TEXEL_PATH", "1");
  if (fast) defines.emplace_back("FAST_NUMERICS", "1");
  return defines;
}

}  // namespace simreel::gl
