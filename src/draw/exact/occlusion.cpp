#include "draw/exact/occlusion.hpp"

#include "draw/exact/bindings.hpp"
#include "draw/rows_at_once.hpp"
#include "gl/element_array.hpp"

#include <string>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

namespace {

void run(const gl::Program& program, int width, int height) {
  program.dispatch(width, (height + rowsAtOnce() - 1) / rowsAtOnce());
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

}  // namespace

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
  horizons_ =
      gl::Program::compute("draw/exact/occlusion/horizons.comp",
                           {rows, {"SLICES", std::to_string(slices)}, {"STEPS", std::to_string(steps)}});
  across_ = gl::Program::compute("draw/exact/occlusion/smooth_arcs.comp", {rows});
  down_ = gl::Program::compute("draw/exact/occlusion/smooth_arcs.comp", {rows, {"DOWN", "1"}});
  nearness_ = gl::Texture::image("nearness", GL_R32F, half_.x, half_.y);
  arcs_ = gl::Texture::image("light that is lost", GL_RGBA32F, half_.x, half_.y);
  smooth_ = gl::Texture::image("light that is lost, along rows", GL_RGBA32F, half_.x, half_.y);
  openness_ = gl::Texture::image("openness", GL_RG32F, half_.x, half_.y);
}

void Occlusion::add(const Visibility& visibility, const shader::ExactView& view) const {
  gl::barrier();
  visibility.bind();
  nearness_.bindImage(nearnessImage, GL_WRITE_ONLY);
  run(nearest_, half_.x, (view.rows.y - view.rows.x + 1) / 2);
}

void Occlusion::find(const shader::ExactView& view, float radius) const {
  nearness_.bindImage(nearnessImage, GL_READ_ONLY);
  arcs_.bindImage(arcImage, GL_WRITE_ONLY);
  horizons_.set("reach", reachOnPicture(view, radius));
  run(horizons_, half_.x, half_.y);
  arcs_.bindImage(arcImage, GL_READ_ONLY);
  smooth_.bindImage(smoothArcImage, GL_WRITE_ONLY);
  run(across_, half_.x, half_.y);
  smooth_.bindImage(arcImage, GL_READ_ONLY);
  openness_.bindImage(opennessImage, GL_WRITE_ONLY);
  run(down_, half_.x, half_.y);
}

void Occlusion::bind() const {
  openness_.bindImage(opennessImage, GL_READ_ONLY);
}

}  // namespace simreel::draw
