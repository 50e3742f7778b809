#include "draw/exact/surface/skin_texels.hpp"

#include "draw/draw_state.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/element_array.hpp"

#include <cstddef>

#include <glm/common.hpp>

namespace simreel::draw {

void SkinTexels::update(const SkinTextures::Entry& entry) {
  constexpr std::size_t texelBytes = 16;
  const glm::ivec2 size(entry.relief.width(), entry.relief.height());
  int count = 0;
  for (int level = 0; level < entry.levels(); ++level) {
    const glm::ivec2 across = glm::max(size >> level, glm::ivec2(1));
    count += across.x * across.y;
  }
  if (!program_) program_ = gl::Program::compute("draw/exact/surface/skin_texels.comp");
  List& list = lists_[&entry];
  list.count = count;
  reserve(list.texels, list.view, "texels of a skin", static_cast<std::size_t>(count) * texelBytes,
          GL_RGBA32UI, texelBytes);
  const bool colored = static_cast<bool>(entry.colors);
  entry.relief.bind(reliefUnit);
  entry.surroundings.bind(surroundingsUnit);
  (colored ? entry.colors : entry.relief).bind(skinColorUnit);
  list.texels.bindStorage(outVertexBinding);
  program_.set("size", size);
  program_.set("count", count);
  program_.set("colored", static_cast<int>(colored));
  gl::barrier();  // another frame may still be read
  dispatchRows(program_, count);
  gl::barrier();
}

}  // namespace simreel::draw
