#include "draw/exact/passes.hpp"

#include "base/error.hpp"
#include "draw/exact/pass_list.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace simreel::draw {

namespace {

void copyOut(const gl::Texture& texture, glm::ivec2 rows, GLenum type, std::span<std::uint32_t> words) {
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTextureSubImage(texture.name(), 0, 0, rows.x, 0, texture.width(), rows.y - rows.x, 1, GL_RGBA, type,
                       static_cast<GLsizei>(words.size_bytes()), words.data());
}

}  // namespace

std::span<std::uint32_t> PassPicture::added(const char* pass, const char* part, glm::ivec2 size, int each,
                                            bool light) {
  // `simreel bisect` compares only the passes in passNames().
  SIMREEL_CHECK(std::find(passNames().begin(), passNames().end(), pass) != passNames().end());
  auto array = std::find_if(arrays.begin(), arrays.end(),
                            [&](const PassArray& one) { return one.pass == pass && one.part == part; });
  if (array == arrays.end()) {
    PassArray fresh;
    fresh.pass = pass;
    fresh.part = part;
    fresh.width = size.x;
    fresh.each = each;
    fresh.light = light;
    array = arrays.insert(arrays.end(), std::move(fresh));
  }
  const std::size_t before = array->words.size();
  const std::size_t words =
      static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(each);
  array->height += size.y;
  array->words.resize(before + words);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  return std::span(array->words).subspan(before);
}

void PassPicture::keep(const char* pass, const char* part, std::span<const std::uint32_t> words,
                       glm::ivec2 size, int each) {
  const auto place = added(pass, part, size, each);
  std::copy_n(words.begin(), place.size(), place.begin());
}

void PassPicture::keepLight(const char* pass, const char* part, const gl::Texture& light, glm::ivec2 rows) {
  const auto words = added(pass, part, {light.width(), rows.y - rows.x}, 4, true);
  copyOut(light, rows, GL_FLOAT, words);
  // Replaces -0 by 0, because min and max return zeros of different sign on different devices. Pictures do
  // not depend on the sign.
  std::replace(words.begin(), words.end(), 0x80000000U, 0U);
}

void PassPicture::keepBytes(const char* pass, const char* part, const gl::Texture& picture) {
  copyOut(picture, {0, picture.height()}, GL_UNSIGNED_BYTE,
          added(pass, part, {picture.width(), picture.height()}, 1));
}

}  // namespace simreel::draw
