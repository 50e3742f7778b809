#pragma once
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/texture.hpp"

#include <cstddef>

namespace simreel::gl {

/// A memory argument of a dispatch. It is a buffer, a part of a buffer, a texture, or an array (a buffer
/// with a texel view). It holds only references, so the objects must exist until the dispatch.
class Resource {
 public:
  /// Creates an empty resource, for a name that a variant of the shader does not have.
  Resource() = default;
  // NOLINTBEGIN(google-explicit-constructor): a dispatch takes the object itself.
  Resource(const Buffer& all) : Resource(all, 0, 0) {}
  Resource(const BufferPart& part) : Resource(*part.buffer, part.offset, part.bytes) {}
  Resource(const Texture& texture) : texture_(&texture), format_(texture.format()) {}
  template <class Element, GLenum format>
  Resource(const ElementArray<Element, format>& array) : Resource(array.buffer()) {
    texture_ = &array.view();
    format_ = format;
  }
  // NOLINTEND(google-explicit-constructor)
  /// Refers to `bytes` bytes of a buffer, starting at `offset`. If `bytes` is 0, refers to all bytes.
  Resource(const Buffer& buffer, std::size_t offset, std::size_t bytes)
      : buffer_(buffer.name()), offset_(offset), bytes_(bytes) {}
  /// Refers to a part of a buffer and to a texel view of that part.
  Resource(const BufferPart& part, const Texture& texels) : Resource(part) {
    texture_ = &texels;
    format_ = texels.format();
  }
  /// Refers to one level of a texture as an image of format `format`.
  Resource(const Texture& texture, GLint level, GLenum format)
      : texture_(&texture), level_(level), format_(format) {}

  [[nodiscard]] bool empty() const { return buffer_ == 0 && texture() == nullptr; }
  /// Returns the OpenGL name of the buffer, or 0 if the resource has no buffer.
  [[nodiscard]] GLuint buffer() const { return buffer_; }
  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// Returns the texture, or null if the resource has no texture.
  [[nodiscard]] const Texture* texture() const {
    return texture_ != nullptr && *texture_ ? texture_ : nullptr;
  }
  [[nodiscard]] GLint level() const { return level_; }
  [[nodiscard]] GLenum format() const { return format_; }

 private:
  GLuint buffer_ = 0;
  std::size_t offset_ = 0, bytes_ = 0;
  const Texture* texture_ = nullptr;
  GLint level_ = 0;
  GLenum format_ = GL_NONE;
};

}  // namespace simreel::gl
