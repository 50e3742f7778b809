#include "draw/exact/reflections/reflections.hpp"

#include "base/error.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/rows_at_once.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "glsl/common/cpp.hpp"

#include <cstddef>

#include <glm/vec4.hpp>

namespace simreel::draw {

struct LevelKernel {
  static constexpr auto file = "draw/exact/reflections/levels.comp";
  struct Variant {
    gl::Range<"ROWS", 1, 8> rows;
    gl::Flag<"FIRST"> first;
    gl::Flag<"GROUND"> ground;
    gl::Flag<"PARALLEL"> parallel;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"level", int> level;
  gl::In<"nearestBefore"> nearestBefore;
  gl::In<"sums"> light;
  gl::In<"litBefore"> litBefore;
  gl::Out<"LitBlock"> lit;
  gl::Out<"NearestBlock"> nearest;
};

struct UnevenKernel {
  static constexpr auto file = "draw/exact/reflections/uneven.comp";
  struct Variant {
    gl::Range<"ROWS", 1, 8> rows;
    gl::Flag<"CLEAR"> clear;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Uniform<"size", glm::ivec2> size;
  gl::In<"changes"> changes = {};
  gl::In<"sums"> light = {};
  gl::In<"unevenTiles"> uneven = {};
  gl::Out<"UnevenBlock"> masks = {};
  gl::Out<"cleared"> cleared = {};
};

struct SpreadKernel {
  static constexpr auto file = "draw/exact/reflections/spread.comp";
  struct Variant {
    gl::Range<"ROWS", 1, 8> rows;
  };
  gl::Uniform<"size", glm::ivec2> size;
  gl::In<"changes"> changes;
  gl::InOut<"sums"> light;
};

namespace {

namespace levels {

using namespace simreel::shader;  // NOLINT: the file is written in GLSL's names
#define FUNCTION inline
#include "glsl/draw/exact/reflections/levels.glsl"
#undef FUNCTION

}  // namespace levels

/// Returns the number of texels of all levels, including the gaps between levels, plus `more`.
std::size_t cellsOf(glm::ivec2 size, std::size_t more) {
  const glm::ivec2 room = levels::levelRoom(size);
  const std::size_t cells =
      static_cast<std::size_t>(room.x) * static_cast<std::size_t>(room.y) / 2 * 3 + more;
  const auto maximum = static_cast<std::size_t>(gl::limits().texelBufferTexels);
  if (cells > maximum)
    fail(
        ExitCode::device,
        "reflections in a picture of {}x{} pixels at half resolution need {} texels; this device allows {} "
        "(GL_MAX_TEXTURE_BUFFER_SIZE); lower \"size\", or set \"render.quality\" to \"draft\"",
        size.x, size.y, cells, maximum);
  return cells;
}

glm::ivec2 tilesOf(glm::ivec2 size) {
  return (size + ShadedTiles::side - 1) / ShadedTiles::side;
}

}  // namespace

Reflections::Levels::Levels(const char* label, GLenum format, std::size_t bytes, glm::ivec2 half,
                            std::size_t more)
    : buffer(label, cellsOf(half, more) * bytes), view(gl::Texture::view(label, format, buffer, bytes)) {}

Reflections::Reflections(glm::ivec2 size, bool ground, bool parallel)
    : size_(size),
      light_("light that is mirrored", GL_RGBA32F, sizeof(glm::vec4), (size + 1) / 2, 0),
      nearest_("nearness, in levels", GL_R32F, sizeof(float), (size + 1) / 2,
               static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
  const gl::Defines none;
  next_ = gl::Kernel<LevelKernel>(
      none, {.rows = rowsAtOnce(), .first = false, .ground = false, .parallel = false});
  first_ = gl::Kernel<LevelKernel>(
      none, {.rows = rowsAtOnce(), .first = true, .ground = ground, .parallel = parallel});
}

Occlusion::PixelNearness Reflections::pixelNearness() const {
  return {&nearest_.buffer, levels::levelCells(levels::levelRoom((size_ + 1) / 2))};
}

void Reflections::see(const gl::Texture& light, const gl::Texture& nearness) const {
  for (int level = 0; level <= levels::lastLevel; ++level) {
    const glm::ivec2 cells = levels::levelSize((size_ + 1) / 2, level);
    (level == 0 ? first_ : next_)
        .dispatch({cells.x, (cells.y + rowsAtOnce() - 1) / rowsAtOnce()},
                  {.size = size_,
                   .level = level,
                   .nearestBefore = level == 0 ? nearness : nearest_.view,
                   .light = light,
                   .litBefore = light_.view,
                   .lit = light_.buffer,
                   .nearest = nearest_.buffer});
  }
  gl::barrier();
}

ReflectedChanges::ReflectedChanges(glm::ivec2 size)
    : changes_(gl::Texture::image("change of light by reflections", GL_RGBA32F, size.x, size.y)) {
  const gl::Defines none;
  kernel_ = gl::Kernel<SpreadKernel>(none, {.rows = rowsAtOnce()});
  find_ = gl::Kernel<UnevenKernel>(none, {.rows = rowsAtOnce(), .clear = false});
  clear_ = gl::Kernel<UnevenKernel>(none, {.rows = rowsAtOnce(), .clear = true});
  const glm::ivec2 tiles = tilesOf(size);
  masks_ = gl::Buffer("uneven half pixels", static_cast<std::size_t>(tiles.x) *
                                                static_cast<std::size_t>(tiles.y) * sizeof(GLuint));
  uneven_ = gl::Texture::view("uneven half pixels", GL_R32UI, masks_, sizeof(GLuint));
}

void ReflectedChanges::clear() const {
  glClearTexImage(changes_.name(), 0, GL_RGBA, GL_FLOAT, nullptr);
}

void ReflectedChanges::findUneven(const gl::Texture& light) const {
  const glm::ivec2 size(changes_.width(), changes_.height());
  const glm::ivec2 tiles = tilesOf(size);
  const glm::ivec2 items(tiles.x, (tiles.y + rowsAtOnce() - 1) / rowsAtOnce());
  gl::barrier();
  find_.dispatch(items, {.size = size, .changes = changes_, .light = light, .masks = masks_});
  clear_.dispatch(items, {.size = size, .uneven = uneven_, .cleared = changes_});
  gl::barrier();
}

void ReflectedChanges::spread(const gl::Texture& light) const {
  const glm::ivec2 size(changes_.width(), changes_.height());
  const glm::ivec2 half = (size + 1) / 2;
  kernel_.dispatch({half.x, (half.y + rowsAtOnce() - 1) / rowsAtOnce()},
                   {.size = size, .changes = changes_, .light = light});
  gl::barrier();
}

}  // namespace simreel::draw
