#pragma once
#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "gl/texture.hpp"

#include <span>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::gl {

/// Elements of four words, reachable as a storage block and as texels; binds the way that
/// glsl/common/words.glsl declares for the current memory path.
class WordsArray {
 public:
  WordsArray() = default;
  /// Zeros.
  WordsArray(const std::string& label, int count)
      : buffer_(label, static_cast<std::size_t>(count) * 16),
        view_(Texture::view(label, GL_RGBA32UI, buffer_)) {}
  WordsArray(const std::string& label, std::span<const glm::uvec4> items)
      : buffer_(Buffer::of(label, items)), view_(Texture::view(label, GL_RGBA32UI, buffer_)) {}

  /// For INPUT_WORDS(unit, ...).
  void bindInput(GLuint unit) const {
    if (memoryPath() == MemoryPath::texel)
      view_.bind(unit);
    else
      buffer_.bindStorage(unit);
  }
  /// For STATE_WORDS(unit, ...).
  void bindState(GLuint unit) const {
    if (memoryPath() == MemoryPath::texel)
      view_.bindImage(unit, GL_READ_WRITE);
    else
      buffer_.bindStorage(unit);
  }
  /// Copies elements to the front.
  void write(std::span<const glm::uvec4> elements) { buffer_.write(0, std::as_bytes(elements)); }
  [[nodiscard]] const Buffer& buffer() const { return buffer_; }
  [[nodiscard]] const Texture& view() const { return view_; }

 private:
  Buffer buffer_;
  Texture view_;
};

}  // namespace simreel::gl
