#include "gl/texture.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <bit>

namespace simreel::gl {

namespace {

GLuint createTexture(GLenum target, const std::string& label) {
  GLuint name = 0;
  glCreateTextures(target, 1, &name);
  glObjectLabel(GL_TEXTURE, name, -1, label.c_str());
  return name;
}

void checkSize(const std::string& label, int width, int height) {
  const int max = limits().textureSize;
  if (width > max || height > max)
    fail(ExitCode::device, "{} is {}x{}, this device allows textures up to {}x{} (GL_MAX_TEXTURE_SIZE)",
         label, width, height, max, max);
}

void checkTexels(const std::string& label, std::size_t bytes, std::size_t texelBytes) {
  const auto max = static_cast<std::size_t>(limits().texelBufferTexels);
  if (bytes / texelBytes > max)
    fail(ExitCode::device,
         "{} has {} elements, this device allows {} in a texel view (GL_MAX_TEXTURE_BUFFER_SIZE)", label,
         bytes / texelBytes, max);
}

}  // namespace

Texture Texture::image(const std::string& label, GLenum format, int width, int height, int levels) {
  checkSize(label, width, height);
  Texture texture;
  texture.handle_ = Handle<DeleteTexture>(createTexture(GL_TEXTURE_2D, label));
  texture.format_ = format;
  texture.width_ = width;
  texture.height_ = height;
  const int all = std::bit_width(static_cast<unsigned>(std::max(width, height)));
  texture.levels_ = levels == 0 ? all : levels;
  glTextureStorage2D(texture.name(), texture.levels_, format, width, height);
  glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER,
                      levels == 1 ? GL_LINEAR : GL_LINEAR_MIPMAP_LINEAR);
  glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

Texture Texture::layered(const std::string& label, GLenum format, int width, int height, int depth,
                         bool array) {
  checkSize(label, width, height);
  GLint maximum = 0;
  glGetIntegerv(array ? GL_MAX_ARRAY_TEXTURE_LAYERS : GL_MAX_3D_TEXTURE_SIZE, &maximum);
  if (depth > maximum || (!array && std::max(width, height) > maximum))
    fail(ExitCode::device, "{} of {} x {} x {} texels is beyond this device's limit of {} ({})", label,
         width, height, depth, maximum, array ? "GL_MAX_ARRAY_TEXTURE_LAYERS" : "GL_MAX_3D_TEXTURE_SIZE");
  Texture texture;
  texture.handle_ =
      Handle<DeleteTexture>(createTexture(array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_3D, label));
  texture.format_ = format;
  texture.width_ = width;
  texture.height_ = height;
  texture.depth_ = depth;
  texture.levels_ = 1;
  glTextureStorage3D(texture.name(), 1, format, width, height, depth);
  texture.unfiltered();
  return texture;
}

Texture Texture::multisampled(const std::string& label, GLenum format, int width, int height, int samples) {
  checkSize(label, width, height);
  Texture texture;
  texture.handle_ = Handle<DeleteTexture>(createTexture(GL_TEXTURE_2D_MULTISAMPLE, label));
  texture.format_ = format;
  texture.width_ = width;
  texture.height_ = height;
  glTextureStorage2DMultisample(texture.name(), samples, format, width, height, GL_TRUE);
  return texture;
}

Texture Texture::view(const std::string& label, GLenum format, const Buffer& buffer,
                      std::size_t texelBytes) {
  checkTexels(label, buffer.bytes(), texelBytes);
  Texture texture;
  texture.handle_ = Handle<DeleteTexture>(createTexture(GL_TEXTURE_BUFFER, label));
  texture.format_ = format;
  texture.buffer_ = buffer.name();
  glTextureBuffer(texture.name(), format, buffer.name());
  return texture;
}

Texture Texture::view(const std::string& label, GLenum format, const BufferPart& part,
                      std::size_t texelBytes) {
  checkTexels(label, part.bytes, texelBytes);
  Texture texture;
  texture.handle_ = Handle<DeleteTexture>(createTexture(GL_TEXTURE_BUFFER, label));
  texture.format_ = format;
  texture.offset_ = part.offset;
  texture.buffer_ = part.buffer->name();
  glTextureBufferRange(texture.name(), format, part.buffer->name(), static_cast<GLintptr>(part.offset),
                       static_cast<GLsizeiptr>(part.bytes));
  return texture;
}

TextureShape Texture::shape() const {
  TextureShape shape;
  shape.format = format_;
  shape.width = width_;
  shape.height = height_;
  shape.levels = levels_;
  if (levels_ > 0) {
    glGetTextureParameteriv(name(), GL_TEXTURE_MIN_FILTER, &shape.filters[0]);
    glGetTextureParameteriv(name(), GL_TEXTURE_MAG_FILTER, &shape.filters[1]);
    glGetTextureParameteriv(name(), GL_TEXTURE_WRAP_S, &shape.wraps[0]);
    glGetTextureParameteriv(name(), GL_TEXTURE_WRAP_T, &shape.wraps[1]);
    return shape;
  }
  GLint buffer = 0, offset = 0, bytes = 0;
  GLint64 all = 0;
  glGetTextureLevelParameteriv(name(), 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
  glGetTextureLevelParameteriv(name(), 0, GL_TEXTURE_BUFFER_OFFSET, &offset);
  glGetTextureLevelParameteriv(name(), 0, GL_TEXTURE_BUFFER_SIZE, &bytes);
  glGetNamedBufferParameteri64v(static_cast<GLuint>(buffer), GL_BUFFER_SIZE, &all);
  shape.bufferBytes = static_cast<std::size_t>(all);
  shape.offset = static_cast<std::size_t>(offset);
  shape.viewBytes = static_cast<std::size_t>(bytes);
  return shape;
}

void Texture::attach(const Buffer& buffer, std::size_t texelBytes) {
  checkTexels("a buffer", buffer.bytes(), texelBytes);
  glTextureBuffer(name(), format_, buffer.name());
}

Framebuffer::Framebuffer(const std::string& label, const Texture* color, const Texture* depth) {
  GLuint created = 0;
  glCreateFramebuffers(1, &created);
  handle_ = Handle<DeleteFramebuffer>(created);
  glObjectLabel(GL_FRAMEBUFFER, name(), -1, label.c_str());
  const Texture* any = color != nullptr ? color : depth;
  SIMREEL_CHECK(any != nullptr);
  width_ = any->width();
  height_ = any->height();
  if (color != nullptr) {
    glNamedFramebufferTexture(name(), GL_COLOR_ATTACHMENT0, color->name(), 0);
  } else {
    glNamedFramebufferDrawBuffer(name(), GL_NONE);
    glNamedFramebufferReadBuffer(name(), GL_NONE);
  }
  if (depth != nullptr) glNamedFramebufferTexture(name(), GL_DEPTH_ATTACHMENT, depth->name(), 0);
  const GLenum status = glCheckNamedFramebufferStatus(name(), GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    fail(ExitCode::device, "the driver refuses the render target {} ({}x{}, status {:#x})", label, width_,
         height_, status);
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, name());
  glViewport(0, 0, width_, height_);
}

TimerQuery::TimerQuery() {
  GLuint name = 0;
  glCreateQueries(GL_TIME_ELAPSED, 1, &name);
  handle_ = Handle<DeleteQuery>(name);
}

double TimerQuery::nanoseconds() const {
  GLuint64 result = 0;
  glGetQueryObjectui64v(handle_.get(), GL_QUERY_RESULT, &result);
  return static_cast<double>(result);
}

}  // namespace simreel::gl
