#include "draw/screen/bloom_pass.hpp"

#include "base/ieee.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace simreel::draw {

namespace {

constexpr float maxLevels = 9.0F;
constexpr const char* layout = "rgba16f";

glm::vec2 texelOf(const gl::Texture& texture) {
  return 1.0F / glm::vec2(static_cast<float>(texture.width()), static_cast<float>(texture.height()));
}

}  // namespace

BloomPass::BloomPass(const scene::Bloom& bloom, glm::ivec2 size, int samples)
    : on_(bloom.strength.moves() || bloom.strength.at(0) > 0),
      threshold_(bloom.threshold),
      // Level i spreads light over about 2^(i + 1) pixels.
      reach_(std::clamp(static_cast<float>(ieee::log2(static_cast<double>(bloom.radius) * size.y)), 1.0F,
                        maxLevels)) {
  if (!on_) return;
  first_ = ScreenProgram<BrightLight>(layout, {.samples = samples});
  down_ = ScreenProgram<BrightLightDown>(layout);
  up_ = ScreenProgram<BrightLightUp>(layout);
  for (int i = 0; i < static_cast<int>(std::ceil(reach_)); ++i) {
    size = (size + 1) / 2;
    levels_.push_back(
        {ScreenTarget("bloom down", GL_RGBA16F, size), ScreenTarget("bloom up", GL_RGBA16F, size)});
    if (std::max(size.x, size.y) <= 2) break;
  }
}

const gl::Texture& BloomPass::draw(const gl::Texture& light) const {
  first_.fill(levels_[0].down,
              {.light = light, .size = glm::ivec2(light.width(), light.height()), .threshold = threshold_});
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    const gl::Texture& fine = levels_[i - 1].down.texture;
    down_.fill(levels_[i].down, {.source = fine, .texel = texelOf(fine)});
  }
  // All levels have equal weight, except the last one, whose weight is the fractional part of `reach_`.
  const float whole = std::min(reach_, static_cast<float>(levels_.size()));
  const gl::Texture* coarse = &levels_.back().down.texture;
  float coarseFraction = whole - static_cast<float>(levels_.size() - 1);
  for (std::size_t i = levels_.size() - 1; i-- > 0;) {
    const float sum = 1.0F + coarseFraction;
    up_.fill(levels_[i].up, {.coarse = *coarse,
                             .fine = levels_[i].down.texture,
                             .coarseTexel = texelOf(*coarse),
                             .fraction = glm::vec2(1.0F, coarseFraction) / sum});
    coarse = &levels_[i].up.texture;
    coarseFraction = sum;
  }
  return *coarse;
}

}  // namespace simreel::draw
