#include "draw/exact/surface/skin_texels.hpp"

#include "draw/exact/reserve.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/element_array.hpp"

#include <cstddef>

#include <glm/common.hpp>

namespace simreel::draw {

struct SkinTexelKernel {
  static constexpr auto file = "draw/exact/surface/skin_texels.comp";
  gl::In<"relief"> relief;
  gl::In<"surroundings"> surroundings;
  gl::In<"skinColors"> colors;
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"count", int> count;
  gl::Uniform<"colored", bool> colored;
  gl::Out<"TexelBlock"> texels;
};

void SkinTexels::update(const SkinTextures::Entry& entry) {
  constexpr std::size_t texelBytes = 16;
  const glm::ivec2 size(entry.relief.width(), entry.relief.height());
  int count = 0;
  for (int level = 0; level < entry.levels(); ++level) {
    const glm::ivec2 across = glm::max(size >> level, glm::ivec2(1));
    count += across.x * across.y;
  }
  if (!kernel_) kernel_ = gl::Kernel<SkinTexelKernel>(gl::Defines());
  List& list = lists_[&entry];
  list.count = count;
  reserve(list.texels, list.view, "texels of a skin", static_cast<std::size_t>(count) * texelBytes,
          GL_RGBA32UI, texelBytes);
  const bool colored = static_cast<bool>(entry.colors);
  kernel_.dispatch(inRows(count), {.relief = entry.relief,
                                   .surroundings = entry.surroundings,
                                   .colors = colored ? entry.colors : entry.relief,
                                   .size = size,
                                   .count = count,
                                   .colored = colored,
                                   .texels = list.texels});
  gl::barrier();
}

}  // namespace simreel::draw
