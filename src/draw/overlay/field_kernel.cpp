#include "draw/overlay/field_kernel.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"
#include "draw/overlay/field_view.hpp"

#include <span>
#include <string>

#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

namespace simreel::draw {

void FieldColors::update(const std::vector<glm::vec3>& wanted) {
  SIMREEL_CHECK(!wanted.empty());
  if (present_ == wanted) return;
  std::vector<glm::vec4> texels;
  texels.reserve(wanted.size());
  // What is too dark to be seen is black: products of it would leave the normal numbers.
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

gl::Defines fieldDefines(const sim::Field& field, bool colored) {
  gl::Defines defines = {{"CELLS", std::to_string(static_cast<int>(field.cells))}};
  if (field.categories) defines.emplace_back("CATEGORIES", "1");
  if (colored) defines.emplace_back("COLORED", "1");
  return defines;
}

void setField(const gl::Program& program, const sim::Field& field, const FieldColors& colors) {
  program.set("cells", field.size);
  program.set("rowWords", field.rowWords);
  program.set("firstWord", field.firstWord);
  program.set("cellWords", field.cellWords);
  program.set("stopCount", colors.stopCount);
  program.set("rangeLow", field.range.x);
  program.set("rangeFactor", rangeFactor(field.range));
  field.words->bind(wordUnit);
  colors.stops.bind(colorUnit);
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
  const int variant = static_cast<int>(field.cells) + (field.categories ? 4 : 0) + (colored ? 8 : 0);
  auto found = programs_.find(variant);
  if (found == programs_.end())
    found = programs_
                .emplace(variant, gl::Program::compute("draw/overlay/field_texture.comp",
                                                       fieldDefines(field, colored)))
                .first;
  const gl::Program& program = found->second;
  setField(program, field, colors);
  const glm::ivec2 size(texture.width(), texture.height());
  program.set("size", size);
  texture.bindImage(targetImage, GL_WRITE_ONLY);
  program.dispatch(size.x, size.y);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                  GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace simreel::draw
