#include "draw/exact/reflections/reflections.hpp"

#include "base/error.hpp"
#include "draw/exact/bindings.hpp"
#include "gl/limits.hpp"
#include "glsl/common/cpp.hpp"

#include <cstddef>

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
         "reflections in a picture of {}x{} pixels: {} cells, and this device has {} "
         "(GL_MAX_TEXTURE_BUFFER_SIZE); lower \"size\", or set \"render.quality\" to \"draft\"",
         size.x, size.y, cells, most);
  return cells;
}

}  // namespace

Reflections::Levels::Levels(const char* label, GLenum format, std::size_t bytes, glm::ivec2 full)
    : size(full), buffer(label, cellsOf(full) * bytes), view(gl::Texture::view(label, format, buffer, bytes)) {}

Reflections::Reflections(glm::ivec2 size)
    : light_("light that is mirrored", GL_RGBA32F, sizeof(glm::vec4), size),
      nearest_("nearness, in levels", GL_R32F, sizeof(float), (size + 1) / 2),
      firstLight_(
          gl::Program::compute("draw/exact/reflections/levels.comp", {{"LIGHT", "1"}, {"FIRST", "1"}})),
      nextLight_(gl::Program::compute("draw/exact/reflections/levels.comp", {{"LIGHT", "1"}})),
      firstNearest_(gl::Program::compute("draw/exact/reflections/levels.comp", {{"FIRST", "1"}})),
      nextNearest_(gl::Program::compute("draw/exact/reflections/levels.comp")) {}

void Reflections::fill(const Levels& levels, GLuint image, const gl::Program& first,
                       const gl::Program& next) {
  levels.buffer.bindStorage(halfPixelBinding);
  for (int level = 0; level <= levels::lastLevel; ++level) {
    const glm::ivec2 cells = levels::levelSize(levels.size, level);
    const gl::Program& kernel = level == 0 ? first : next;
    if (level > 0) levels.view.bindImage(image, GL_READ_ONLY);
    kernel.set("size", levels.size);
    kernel.set("level", level);
    kernel.dispatch(cells.x, cells.y);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  }
}

void Reflections::see(const gl::Texture& light, const gl::Texture& nearness) const {
  light.bindImage(sumImage, GL_READ_ONLY);
  fill(light_, litImage, firstLight_, nextLight_);
  nearness.bindImage(nearnessImage, GL_READ_ONLY);
  fill(nearest_, nearnessImage, firstNearest_, nextNearest_);
}

void Reflections::bind() const {
  light_.view.bindImage(litImage, GL_READ_ONLY);
  nearest_.view.bindImage(nearnessImage, GL_READ_ONLY);
}

}  // namespace simreel::draw
