#include "draw/overlay/writing_pass.hpp"

#include "draw/overlay/box_kernel.hpp"
#include "draw/picture_code.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

struct WritingKernel {
  static constexpr auto file = "draw/overlay/writing.comp";
  gl::In<"shares"> shares;
  gl::InOut<"target"> target;
  gl::Uniform<"panel", glm::ivec4> panel;
  gl::Uniform<"box", glm::ivec4> box;
  gl::Uniform<"color", glm::vec3> color;
  gl::Uniform<"opacity", float> opacity;
  gl::Uniform<"backdrop", float> backdrop;
};

void WritingPass::cover(const sim::Writing& writing, Kept& kept) const {
  const glm::dvec2 size(picture_);
  const double unit = static_cast<double>(writing.height) * size.y;
  const glm::dvec2 place = glm::dvec2(writing.place) * size;
  std::vector<std::vector<glm::dvec2>> polygons;
  for (const auto& polygon : *writing.outlines) {
    auto& put = polygons.emplace_back();
    for (const glm::vec2& point : polygon)
      put.push_back(place + unit * glm::dvec2(static_cast<double>(point.x), -static_cast<double>(point.y)));
  }
  if (polygons == kept.polygons) return;
  kept.polygons = std::move(polygons);
  kept.coverage = coverageOf(kept.polygons, picture_);
  if (kept.coverage.share.empty()) return;
  kept.shares = gl::Buffer::of<std::uint8_t>("letters", kept.coverage.share);
  kept.view = gl::Texture::view("letters", GL_R8UI, kept.shares, 1);
}

void WritingPass::draw(const sim::Drawables& drawables, const gl::Texture& picture) {
  if (drawables.writings.empty()) return;
  if (!kernel_) kernel_ = gl::Kernel<WritingKernel>(gl::Defines());
  kept_.resize(drawables.writings.size());
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const sim::Writing& writing = drawables.writings[i];
    Kept& kept = kept_[i];
    cover(writing, kept);
    const Coverage& coverage = kept.coverage;
    if (coverage.share.empty() || !(writing.opacity > 0)) continue;
    // The background box extends beyond the letters by half the height of a capital.
    const auto margin =
        static_cast<int>(std::lround(0.5F * writing.height * static_cast<float>(picture_.y)));
    const int around = writing.backdrop > 0 ? margin : 0;
    const glm::ivec2 from = glm::max(coverage.corner - around, glm::ivec2(0));
    const glm::ivec2 end = glm::min(coverage.corner + coverage.size + around, picture_);
    kernel_.dispatch(end - from, {.shares = kept.view,
                                  .target = picture,
                                  .panel = glm::ivec4(from, end),
                                  .box = glm::ivec4(coverage.corner, coverage.corner + coverage.size),
                                  .color = shader::encoded(glm::clamp(writing.color, 0.0F, 1.0F)),
                                  .opacity = writing.opacity,
                                  .backdrop = writing.backdrop});
  }
  imageBarrier();
}

}  // namespace simreel::draw
