#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <algorithm>

namespace simreel::draw {

/// Makes room for `bytes` at least; what was there may be lost.
inline bool reserve(gl::Buffer& buffer, const char* label, std::size_t bytes) {
  constexpr std::size_t least = 256;
  if (buffer.name() != 0 && buffer.bytes() >= bytes) return false;
  buffer = {};
  buffer = gl::Buffer(label, std::max(bytes, least));
  return true;
}

/// The same with a texel view of it.
inline void reserve(gl::Buffer& buffer, gl::Texture& view, const char* label, std::size_t bytes,
                    GLenum format, std::size_t texelBytes) {
  if (reserve(buffer, label, bytes)) view = gl::Texture::view(label, format, buffer, texelBytes);
}

}  // namespace simreel::draw
