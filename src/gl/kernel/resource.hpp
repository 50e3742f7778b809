#pragma once
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/texture.hpp"

#include <cstddef>

namespace simreel::gl {

/// Memory that a dispatch is given: a buffer (or a part of one), a texture, or an array that is a buffer
/// and a view of it. None of it is copied: it lives until the dispatch.
class Resource {
 public:
  /// Empty: for a resource that a variant of the shader does not have.
  Resource() = default;
  // NOLINTBEGIN(google-explicit-constructor): a dispatch is given the thing itself.
  Resource(const Buffer& all) : Resource(all, 0, 0) {}
  Resource(const BufferPart& part) : Resource(*part.buffer, part.offset, part.bytes) {}
  Resource(const Texture& texture) : texture_(&texture), format_(texture.format()) {}
  template <class Element, GLenum format>
  Resource(const ElementArray<Element, format>& array) : Resource(array.buffer()) {
    texture_ = &array.view();
    format_ = format;
  }
  // NOLINTEND(google-explicit-constructor)
  /// `bytes` of a buffer from `offset` on; 0: all.
  Resource(const Buffer& buffer, std::size_t offset, std::size_t bytes)
      : buffer_(buffer.name()), offset_(offset), bytes_(bytes) {}
  /// A part of a buffer and its texels.
  Resource(const BufferPart& part, const Texture& texels) : Resource(part) {
    texture_ = &texels;
    format_ = texels.format();
  }
  /// One level of a texture as an image, read and written as `format`.
  Resource(const Texture& texture, GLint level, GLenum format)
      : texture_(&texture), level_(level), format_(format) {}

  [[nodiscard]] bool empty() const { return buffer_ == 0 && texture() == nullptr; }
  /// The driver's name of the buffer; 0 for none.
  [[nodiscard]] GLuint buffer() const { return buffer_; }
  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// Null for none.
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
