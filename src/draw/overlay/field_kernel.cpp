#include "draw/overlay/field_kernel.hpp"

#include "base/error.hpp"
#include "draw/overlay/field_view.hpp"
#include "gl/element_array.hpp"

#include <span>
#include <string>

#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

namespace simreel::draw {

struct AverageField {
  static constexpr auto file = "draw/overlay/field_texture.comp";
  using Variant = FieldVariant;
  FieldInputs field;
  gl::Out<"texels"> texels;
  gl::Uniform<"size", glm::ivec2> size;
};

void FieldColors::update(const std::vector<glm::vec3>& wanted) {
  SIMREEL_CHECK(!wanted.empty());
  if (present_ == wanted) return;
  std::vector<glm::vec4> texels;
  texels.reserve(wanted.size());
  // Very dark colours become black, because their products could be subnormal.
  for (const glm::vec3& color : wanted)
    texels.emplace_back(color * glm::vec3(glm::greaterThanEqual(glm::abs(color), glm::vec3(1e-8F))), 1.0F);
  if (present_.size() == wanted.size()) {
    stopBuffer.write(0, std::as_bytes(std::span(texels)));
  } else {
    stopBuffer = gl::Buffer::of<glm::vec4>("field colours", texels);
    stops = gl::Texture::view("field colours", GL_RGBA32F, stopBuffer);
    stopCount = static_cast<int>(wanted.size());
  }
  present_ = wanted;
}

FieldVariant fieldVariant(const sim::Field& field, bool colored) {
  return {.cells = field.cells, .categories = field.categories, .colored = colored};
}

FieldInputs fieldInputs(const sim::Field& field, const FieldColors& colors) {
  return {.words = *field.words,
          .stops = colors.stops,
          .cells = field.size,
          .rowWords = field.rowWords,
          .firstWord = field.firstWord,
          .cellWords = field.cellWords,
          .stopCount = colors.stopCount,
          .rangeLow = field.range.x,
          .rangeFactor = rangeFactor(field.range)};
}

gl::Texture FieldKernel::texture(const sim::Field& field, int reduction, bool colored, int levels) {
  const glm::ivec2 size = (field.size + reduction - 1) / reduction;
  gl::Texture texture = gl::Texture::image("field " + (field.name != nullptr ? *field.name : std::string()),
                                           colored ? GL_RGBA16F : GL_R32F, size.x, size.y, levels);
  texture.wrap(GL_REPEAT);
  return texture;
}

void FieldKernel::average(const sim::Field& field, const FieldColors& colors, const gl::Texture& texture,
                          bool colored) {
  const glm::ivec2 size(texture.width(), texture.height());
  kernels_.of(fieldVariant(field, colored))
      .dispatch(size, {.field = fieldInputs(field, colors), .texels = texture, .size = size});
  gl::barrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace simreel::draw
