#include "draw/exact/occlusion/occlusion.hpp"

#include "draw/exact/bindings.hpp"
#include "draw/rows_at_once.hpp"
#include "gl/element_array.hpp"

#include <string>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

Occlusion::Kept::Kept(const std::string& label, GLenum format, std::size_t bytes, glm::ivec2 size)
    : buffer(label, static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * bytes),
      view(gl::Texture::view(label, format, buffer, bytes)) {}

void Occlusion::run(const gl::Program& program, const Kept& result, glm::ivec2 size,
                    glm::ivec2 each) const {
  result.buffer.bindStorage(halfPixelBinding);
  const glm::ivec2 invocations = (size + each - 1) / each;
  program.dispatch(invocations.x, invocations.y);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

glm::vec3 reachOnPicture(const shader::ExactView& view, float radius) {
  // Of the picture's height a third, whatever its size: larger ones show the same.
  const float most = static_cast<float>(view.size.y) / 6.0F;
  return {radius, most, 0.5F / glm::length(glm::vec3(view.rayAcross))};
}

Occlusion::Occlusion(glm::ivec2 size, const Visibility& visibility, bool ground) : half_((size + 1) / 2) {
  const std::pair<const char*, std::string> rows = {"ROWS", std::to_string(rowsAtOnce())};
  gl::Defines nearest = definesOf(visibility.layout());
  nearest.emplace_back("SAMPLES", std::to_string(visibility.samples()));
  nearest.push_back(rows);
  if (ground) nearest.emplace_back("GROUND", "1");
  nearest_ = gl::Program::compute("draw/exact/occlusion/half_nearness.comp", nearest);
  gl::Defines along = {rows};
  if (visibility.layout().parallel) along.emplace_back("PARALLEL", "1");
  gl::Defines around = along, down = along;
  around.emplace_back("SLICES", std::to_string(slices));
  around.emplace_back("STEPS", std::to_string(steps));
  down.emplace_back("DOWN", "1");
  horizons_ = gl::Program::compute("draw/exact/occlusion/horizons.comp", around);
  across_ = gl::Program::compute("draw/exact/occlusion/smooth_arcs.comp", along);
  down_ = gl::Program::compute("draw/exact/occlusion/smooth_arcs.comp", down);
  nearness_ = Kept("nearness", GL_R32F, sizeof(float), half_);
  arcs_ = Kept("light that is lost", GL_RG32F, sizeof(glm::vec2), half_);
  smooth_ = Kept("light that is lost, along rows", GL_RG32F, sizeof(glm::vec2), half_);
  openness_ = Kept("openness", GL_RG32F, sizeof(glm::vec2), half_);
}

void Occlusion::add(const Visibility& visibility, const shader::ExactView& view) const {
  gl::barrier();
  visibility.bind();
  run(nearest_, nearness_, {half_.x, (view.rows.y - view.rows.x + 1) / 2}, {1, rowsAtOnce()});
}

void Occlusion::find(const shader::ExactView& view, float radius) const {
  nearness_.view.bindImage(nearnessImage, GL_READ_ONLY);
  horizons_.set("reach", reachOnPicture(view, radius));
  run(horizons_, arcs_, half_, {1, rowsAtOnce()});
  arcs_.view.bindImage(arcImage, GL_READ_ONLY);
  run(across_, smooth_, half_, {rowsAtOnce(), 1});
  smooth_.view.bindImage(arcImage, GL_READ_ONLY);
  run(down_, openness_, half_, {1, rowsAtOnce()});
}

void Occlusion::bind() const {
  openness_.view.bindImage(opennessImage, GL_READ_ONLY);
}

}  // namespace simreel::draw
