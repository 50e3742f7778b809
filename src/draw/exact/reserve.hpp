#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <algorithm>

namespace simreel::draw {

/// Ensures that the buffer has at least `bytes`. Returns true if the buffer was replaced, which loses the
/// contents. The new buffer may have the same GL name.
inline bool reserve(gl::Buffer& buffer, const char* label, std::size_t bytes) {
  constexpr std::size_t minimum = 256;
  if (buffer.name() != 0 && buffer.bytes() >= bytes) return false;
  buffer = {};
  buffer = gl::Buffer(label, std::max(bytes, minimum));
  return true;
}

/// Ensures that the buffer has at least `bytes`, and recreates the buffer's texel view if the buffer was
/// replaced.
inline bool reserve(gl::Buffer& buffer, gl::Texture& view, const char* label, std::size_t bytes,
                    GLenum format, std::size_t texelBytes) {
  if (!reserve(buffer, label, bytes)) return false;
  view = gl::Texture::view(label, format, buffer, texelBytes);
  return true;
}

}  // namespace simreel::draw
