#include "draw/surface/skin_maps.hpp"

#include "draw/surface/skin_look.hpp"
#include "gl/errors.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

SkinMaps SkinMapper::draw(const SkinTextures::Entry& entry, const scene::Skin& skin, glm::ivec2 size) {
  auto found = programs_.find(skin.look);
  if (found == programs_.end()) {
    const gl::Defines defines = {{lookOf(skin).define, "1"}};
    found = programs_
                .emplace(skin.look, gl::Program::graphics("draw/screen/screen.vert",
                                                          "draw/surface/skin_maps.frag", defines))
                .first;
  }
  const gl::Program& program = found->second;
  const gl::Texture target = gl::Texture::image("skin maps", GL_RGBA32F, size.x, size.y);
  const gl::Framebuffer framebuffer("skin maps", &target, nullptr);
  framebuffer.bind();
  DrawState{.depthTest = false}.set();
  SkinTextures::bind(entry, skin, program);
  program.set("mapSize", size);
  vertices_.bind();
  SkinMaps maps{size, {}, {}, {}};
  std::vector<glm::vec4>* const parts[] = {&maps.surface, &maps.relief, &maps.light};
  for (int part = 0; part < 3; ++part) {
    program.set("part", part);
    program.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<glm::vec4>& texels = *parts[part];
    texels.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureImage(target.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
    gl::checkCalls();
  }
  return maps;
}

}  // namespace simreel::draw
