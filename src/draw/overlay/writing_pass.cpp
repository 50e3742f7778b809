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

void TextPass::cover(const sim::Writing& writing, Cached& cached) const {
  const glm::dvec2 size(picture_);
  const double unit = static_cast<double>(writing.height) * size.y;
  const glm::dvec2 place = glm::dvec2(writing.place) * size;
  std::vector<std::vector<glm::dvec2>> polygons;
  for (const auto& polygon : *writing.outlines) {
    auto& put = polygons.emplace_back();
    for (const glm::vec2& point : polygon)
      put.push_back(place + unit * glm::dvec2(static_cast<double>(point.x), -static_cast<double>(point.y)));
  }
  if (polygons == cached.polygons) return;
  cached.polygons = std::move(polygons);
  cached.coverage = coverageOf(cached.polygons, picture_);
  if (cached.coverage.share.empty()) return;
  cached.shares = gl::Buffer::of<std::uint8_t>("letters", cached.coverage.share);
  cached.view = gl::Texture::view("letters", GL_R8UI, cached.shares, 1);
}

void TextPass::draw(const sim::Drawables& drawables, const gl::Texture& picture) {
  if (drawables.writings.empty()) return;
  if (!kernel_) kernel_ = gl::Kernel<WritingKernel>(gl::Defines());
  cached_.resize(drawables.writings.size());
  for (std::size_t i = 0; i < cached_.size(); ++i) {
    const sim::Writing& writing = drawables.writings[i];
    Cached& cached = cached_[i];
    cover(writing, cached);
    const Coverage& coverage = cached.coverage;
    if (coverage.share.empty() || !(writing.opacity > 0)) continue;
    // The background box extends beyond the letters by half the height of a capital.
    const auto margin =
        static_cast<int>(std::lround(0.5F * writing.height * static_cast<float>(picture_.y)));
    const int around = writing.backdrop > 0 ? margin : 0;
    const glm::ivec2 from = glm::max(coverage.corner - around, glm::ivec2(0));
    const glm::ivec2 end = glm::min(coverage.corner + coverage.size + around, picture_);
    kernel_.dispatch(end - from, {.shares = cached.view,
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
