#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <algorithm>

namespace simreel::draw {

/// Makes room for `bytes` at least. True where what was there is lost for it; the buffer's name may be the
/// same even then.
inline bool reserve(gl::Buffer& buffer, const char* label, std::size_t bytes) {
  constexpr std::size_t least = 256;
  if (buffer.name() != 0 && buffer.bytes() >= bytes) return false;
  buffer = {};
  buffer = gl::Buffer(label, std::max(bytes, least));
  return true;
}

/// The same with a texel view of it.
inline bool reserve(gl::Buffer& buffer, gl::Texture& view, const char* label, std::size_t bytes,
                    GLenum format, std::size_t texelBytes) {
  if (!reserve(buffer, label, bytes)) return false;
  view = gl::Texture::view(label, format, buffer, texelBytes);
  return true;
}

}  // namespace simreel::draw
