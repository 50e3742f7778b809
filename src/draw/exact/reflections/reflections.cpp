#include "draw/exact/reflections/reflections.hpp"

#include "base/error.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/rows_at_once.hpp"
#include "gl/limits.hpp"
#include "glsl/common/cpp.hpp"

#include <cstddef>
#include <string>

#include <glm/vec4.hpp>

namespace simreel::draw {

namespace {

namespace levels {

using namespace simreel::shader;  // NOLINT: the file is written in GLSL's names
#define FUNCTION inline
#include "glsl/draw/exact/reflections/levels.glsl"
#undef FUNCTION

}  // namespace levels

/// Cells of all levels, and of the room between them.
std::size_t cellsOf(glm::ivec2 size) {
  const glm::ivec2 room = levels::levelRoom(size);
  const std::size_t cells = static_cast<std::size_t>(room.x) * static_cast<std::size_t>(room.y) / 2 * 3;
  const auto most = static_cast<std::size_t>(gl::limits().texelBufferTexels);
  if (cells > most)
    fail(ExitCode::device,
         "reflections in a picture of {}x{} half pixels: {} cells, and this device has {} "
         "(GL_MAX_TEXTURE_BUFFER_SIZE); lower \"size\", or set \"render.quality\" to \"draft\"",
         size.x, size.y, cells, most);
  return cells;
}

}  // namespace

Reflections::Levels::Levels(const char* label, GLenum format, std::size_t bytes, glm::ivec2 half)
    : buffer(label, cellsOf(half) * bytes), view(gl::Texture::view(label, format, buffer, bytes)) {}

Reflections::Reflections(glm::ivec2 size, bool ground, bool parallel)
    : size_(size),
      light_("light that is mirrored", GL_RGBA32F, sizeof(glm::vec4), (size + 1) / 2),
      nearest_("nearness, in levels", GL_R32F, sizeof(float), (size + 1) / 2) {
  const gl::Defines rows = {{"ROWS", std::to_string(rowsAtOnce())}};
  next_ = gl::Program::compute("draw/exact/reflections/levels.comp", rows);
  gl::Defines first = rows;
  first.emplace_back("FIRST", "1");
  if (ground) first.emplace_back("GROUND", "1");
  if (parallel) first.emplace_back("PARALLEL", "1");
  first_ = gl::Program::compute("draw/exact/reflections/levels.comp", first);
}

void Reflections::see(const gl::Texture& light, const gl::Texture& nearness) const {
  light.bindImage(sumImage, GL_READ_ONLY);
  nearness.bindImage(nearnessImage, GL_READ_ONLY);
  light_.buffer.bindStorage(litBinding);
  nearest_.buffer.bindStorage(halfPixelBinding);
  for (int level = 0; level <= levels::lastLevel; ++level) {
    const glm::ivec2 cells = levels::levelSize((size_ + 1) / 2, level);
    const gl::Program& kernel = level == 0 ? first_ : next_;
    kernel.set("size", size_);
    kernel.set("level", level);
    kernel.dispatch(cells.x, (cells.y + rowsAtOnce() - 1) / rowsAtOnce());
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    bind();
  }
}

void Reflections::bind() const {
  light_.view.bindImage(litImage, GL_READ_ONLY);
  nearest_.view.bindImage(nearnessImage, GL_READ_ONLY);
}

}  // namespace simreel::draw
