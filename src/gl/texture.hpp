#pragma once
#include "gl/buffer.hpp"
#include "gl/handle.hpp"
#include "gl/rehearsal.hpp"

#include <cstddef>
#include <string>

namespace simreel::gl {

/// A texture. It may be 2-D, multisampled, layered or 3-D, or a texel view of a Buffer.
class Texture {
 public:
  Texture() = default;
  /// Creates a 2-D texture with immutable storage. If `levels` is 0, the texture has the full mip chain.
  static Texture image(const std::string& label, GLenum format, int width, int height, int levels = 1);
  /// Creates a texture with immutable storage of one level. It is a 2-D array if `array` is true, and
  /// otherwise 3-D.
  static Texture layered(const std::string& label, GLenum format, int width, int height, int depth,
                         bool array);
  static Texture multisampled(const std::string& label, GLenum format, int width, int height, int samples);
  /// Creates a texel view of a buffer for samplerBuffer / imageBuffer, with a format such as GL_RGBA32F.
  /// The Buffer must outlive the view. Throws UserError(device) if GL_MAX_TEXTURE_BUFFER_SIZE is exceeded.
  static Texture view(const std::string& label, GLenum format, const Buffer& buffer,
                      std::size_t texelBytes = 16);

  /// Creates a texel view of a part of a buffer.
  static Texture view(const std::string& label, GLenum format, const BufferPart& part,
                      std::size_t texelBytes = 16);

  /// Redirects the view to another or reallocated buffer.
  void attach(const Buffer& buffer, std::size_t texelBytes);

  void bind(GLuint unit) const {
    if (depth_ == 0) Rehearsal::bound(unit, *this);
    glBindTextureUnit(unit, name());
  }
  /// Sets the wrap mode for reads outside the texture. `mode` is GL_REPEAT or GL_CLAMP_TO_EDGE.
  void wrap(GLint mode) const {
    glTextureParameteri(name(), GL_TEXTURE_WRAP_S, mode);
    glTextureParameteri(name(), GL_TEXTURE_WRAP_T, mode);
  }
  /// Switches filtering off, for textures read with texelFetch. Integer formats require this.
  void unfiltered() const {
    glTextureParameteri(name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTextureParameteri(name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  void bindImage(GLuint unit, GLenum access) const { bindImage(unit, 0, access, format_); }

  /// Binds one level as an image of format `format`.
  void bindImage(GLuint unit, GLint level, GLenum access, GLenum format) const {
    if (depth_ == 0) Rehearsal::boundImage(unit, *this, level, access, format);
    glBindImageTexture(unit, name(), level, depth_ == 0 ? GL_FALSE : GL_TRUE, 0, access, format);
  }

  /// Returns the properties that affect the machine code of a software driver.
  [[nodiscard]] TextureShape shape() const;
  [[nodiscard]] GLuint name() const { return handle_.get(); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] int depth() const { return depth_; }
  [[nodiscard]] GLenum format() const { return format_; }
  /// Returns the OpenGL name of the buffer of a texel view, or 0 for other textures.
  [[nodiscard]] GLuint buffer() const { return buffer_; }
  /// Returns the byte offset of a texel view in its buffer.
  [[nodiscard]] std::size_t offset() const { return offset_; }
  explicit operator bool() const { return static_cast<bool>(handle_); }

 private:
  Handle<DeleteTexture> handle_;
  GLenum format_ = GL_NONE;
  int width_ = 0;
  int height_ = 0;
  int depth_ = 0;   ///< only for layered(); 0 for other textures
  int levels_ = 0;  ///< 0 for a texel view
  std::size_t offset_ = 0;
  GLuint buffer_ = 0;
};

/// A framebuffer with optional colour and depth attachments.
class Framebuffer {
 public:
  Framebuffer() = default;
  /// Creates a framebuffer. Either attachment may be null. Throws UserError(device) if the driver rejects
  /// the combination.
  Framebuffer(const std::string& label, const Texture* color, const Texture* depth);
  void bind() const;
  [[nodiscard]] GLuint name() const { return handle_.get(); }

 private:
  Handle<DeleteFramebuffer> handle_;
  int width_ = 0;
  int height_ = 0;
};

/// Measures the GPU time between begin and end, in nanoseconds.
class TimerQuery {
 public:
  TimerQuery();
  void begin() { glBeginQuery(GL_TIME_ELAPSED, handle_.get()); }
  void end() { glEndQuery(GL_TIME_ELAPSED); }
  /// Waits for the result and returns it.
  [[nodiscard]] double nanoseconds() const;

 private:
  Handle<DeleteQuery> handle_;
};

}  // namespace simreel::gl
