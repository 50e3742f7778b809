#include "sim/grid/field_values.hpp"

#include "base/error.hpp"
#include "gl/errors.hpp"

#include <bit>
#include <cstdint>

namespace simreel::sim {

namespace {

/// Reads back the words from the first cell's word to the last cell's word.
std::vector<std::uint32_t> wordsOf(const Field& field) {
  const int perWord = field.cells == Field::Cells::bits ? 32 : field.cells == Field::Cells::bytes ? 4 : 1;
  const bool whole = perWord == 1;
  const std::int64_t cellStride = whole ? field.cellWords : 1;
  const std::int64_t beyond = field.cells == Field::Cells::colors ? 4 : 1;
  const std::int64_t count =
      std::int64_t{field.size.y - 1} * field.rowWords + (field.size.x - 1) * cellStride / perWord + beyond;
  GLint buffer = 0;
  glGetTextureLevelParameteriv(field.words->name(), 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
  gl::checkCalls();
  SIMREEL_CHECK(buffer != 0);
  std::vector<std::uint32_t> words(static_cast<std::size_t>(count));
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(static_cast<GLuint>(buffer),
                          static_cast<GLintptr>(field.words->offset()) + GLintptr{field.firstWord} * 4,
                          static_cast<GLsizeiptr>(words.size() * 4), words.data());
  gl::checkCalls();
  return words;
}

}  // namespace

std::vector<float> fieldValues(const Field& field) {
  if (field.size.x < 1 || field.size.y < 1) return {};
  const auto words = wordsOf(field);
  const auto width = static_cast<std::size_t>(field.size.x);
  const auto height = static_cast<std::size_t>(field.size.y);
  std::vector<float> values;
  values.reserve(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint32_t* row = &words[y * static_cast<std::size_t>(field.rowWords)];
    for (std::size_t x = 0; x < width; ++x) switch (field.cells) {
        case Field::Cells::bits:
          values.push_back(static_cast<float>(row[x / 32] >> (x % 32) & 1U));
          break;
        case Field::Cells::bytes:
          values.push_back(static_cast<float>(row[x / 4] >> (8 * (x % 4)) & 255U));
          break;
        case Field::Cells::floats:
          values.push_back(std::bit_cast<float>(row[x * static_cast<std::size_t>(field.cellWords)]));
          break;
        case Field::Cells::colors:
          values.push_back(std::bit_cast<float>(row[x * static_cast<std::size_t>(field.cellWords) + 3]));
          break;
      }
  }
  return values;
}

}  // namespace simreel::sim
