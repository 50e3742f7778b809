#include "draw/exact/passes.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace simreel::draw {

namespace {

PassArray arrayOf(const char* pass, const char* part, glm::ivec2 size, int each) {
  PassArray array;
  array.pass = pass;
  array.part = part;
  array.width = size.x;
  array.height = size.y;
  array.each = each;
  array.words.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                     static_cast<std::size_t>(each));
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  return array;
}

void copyOut(const gl::Texture& texture, GLenum type, PassArray& array) {
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTextureImage(texture.name(), 0, GL_RGBA, type, static_cast<GLsizei>(array.words.size() * 4),
                    array.words.data());
}

}  // namespace

void PassPicture::keep(const char* pass, const char* part, const gl::Buffer& words, glm::ivec2 size,
                       int each) {
  PassArray array = arrayOf(pass, part, size, each);
  words.read(0, std::as_writable_bytes(std::span(array.words)));
  arrays.push_back(std::move(array));
}

void PassPicture::keepLight(const char* pass, const char* part, const gl::Texture& light) {
  PassArray array = arrayOf(pass, part, {light.width(), light.height()}, 4);
  array.light = true;
  copyOut(light, GL_FLOAT, array);
  // Which of two zeros a minimum or maximum is, devices may choose; no picture depends on it.
  std::replace(array.words.begin(), array.words.end(), 0x80000000U, 0U);
  arrays.push_back(std::move(array));
}

void PassPicture::keepBytes(const char* pass, const char* part, const gl::Texture& picture) {
  PassArray array = arrayOf(pass, part, {picture.width(), picture.height()}, 1);
  copyOut(picture, GL_UNSIGNED_BYTE, array);
  arrays.push_back(std::move(array));
}

}  // namespace simreel::draw
