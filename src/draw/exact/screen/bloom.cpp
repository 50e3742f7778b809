#include "draw/exact/screen/bloom.hpp"

#include "base/ieee.hpp"
#include "draw/exact/screen/light_pictures.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace simreel::draw {

namespace {

constexpr float maxLevels = 9.0F;

void run(const gl::Program& program, const gl::Texture& result) {
  result.bindImage(sumImage, GL_WRITE_ONLY);
  program.dispatch(result.width(), result.height());
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

glm::ivec2 sizeOf(const gl::Texture& texture) {
  return {texture.width(), texture.height()};
}

}  // namespace

Bloom::Bloom(const scene::Bloom& bloom, glm::ivec2 size)
    : threshold_(bloom.threshold),
      // Level i spreads light over about 2^(i + 1) pixels.
      reach_(std::clamp(static_cast<float>(ieee::log2(static_cast<double>(bloom.radius) * size.y)), 1.0F,
                        maxLevels)) {
  if (!on(bloom)) return;
  first_ = gl::Program::compute("draw/exact/screen/bloom_first.comp", lightDefines());
  down_ = gl::Program::compute("draw/exact/screen/bloom_down.comp", lightDefines());
  up_ = gl::Program::compute("draw/exact/screen/bloom_up.comp", lightDefines());
  for (int i = 0; i < static_cast<int>(std::ceil(reach_)); ++i) {
    size = (size + 1) / 2;
    const auto level = [&](const char* label) {
      return gl::Texture::image(label, GL_RGBA32F, size.x, size.y);
    };
    levels_.push_back({level("bloom down"), level("bloom up")});
    if (std::max(size.x, size.y) <= 2) break;
  }
}

const gl::Texture& Bloom::draw(const gl::Texture& light) const {
  first_.set("size", sizeOf(light));
  first_.set("threshold", threshold_);
  bindLight(light, sceneUnit, lightImage);
  run(first_, levels_[0].down);
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    down_.set("size", sizeOf(levels_[i - 1].down));
    bindLight(levels_[i - 1].down, sceneUnit, lightImage);
    run(down_, levels_[i].down);
  }
  // Each level has the same share, the last what is left of `reach_`.
  const float whole = std::min(reach_, static_cast<float>(levels_.size()));
  const gl::Texture* coarse = &levels_.back().down;
  float coarseFraction = whole - static_cast<float>(levels_.size() - 1);
  for (std::size_t i = levels_.size() - 1; i-- > 0;) {
    const float sum = 1.0F + coarseFraction;
    up_.set("size", sizeOf(levels_[i].up));
    up_.set("coarseSize", sizeOf(*coarse));
    up_.set("fraction", glm::vec2(1.0F, coarseFraction) / sum);
    bindLight(*coarse, sceneUnit, lightImage);
    bindLight(levels_[i].down, bloomUnit, scatteredImage);
    run(up_, levels_[i].up);
    coarse = &levels_[i].up;
    coarseFraction = sum;
  }
  return *coarse;
}

}  // namespace simreel::draw
