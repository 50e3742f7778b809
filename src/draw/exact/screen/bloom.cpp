#include "draw/exact/screen/bloom.hpp"

#include "base/ieee.hpp"
#include "draw/exact/screen/light_pictures.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace simreel::draw {

struct BloomFirst {
  static constexpr auto file = "draw/exact/screen/bloom_first.comp";
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"threshold", float> threshold;
  gl::In<"scene"> light;
  gl::Out<"half_"> half;
};

struct BloomDown {
  static constexpr auto file = "draw/exact/screen/bloom_down.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::In<"fine"> fine;
  gl::Out<"coarse"> coarse;
};

struct BloomUp {
  static constexpr auto file = "draw/exact/screen/bloom_up.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"coarseSize", glm::ivec2> coarseSize;
  gl::Uniform<"fraction", glm::vec2> fraction;
  gl::In<"coarse"> coarse;
  gl::In<"fine"> fine;
  gl::Out<"sum_"> sum;
};

namespace {

constexpr float maxLevels = 9.0F;

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
  first_ = gl::Kernel<BloomFirst>(lightDefines());
  down_ = gl::Kernel<BloomDown>(lightDefines());
  up_ = gl::Kernel<BloomUp>(lightDefines());
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
  first_.dispatch(
      sizeOf(levels_[0].down),
      {.size = sizeOf(light), .threshold = threshold_, .light = light, .half = levels_[0].down});
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    const gl::Texture& fine = levels_[i - 1].down;
    down_.dispatch(sizeOf(levels_[i].down),
                   {.size = sizeOf(fine), .fine = fine, .coarse = levels_[i].down});
  }
  // All levels have equal weight, except the last one, whose weight is the fractional part of `reach_`.
  const float whole = std::min(reach_, static_cast<float>(levels_.size()));
  const gl::Texture* coarse = &levels_.back().down;
  float coarseFraction = whole - static_cast<float>(levels_.size() - 1);
  for (std::size_t i = levels_.size() - 1; i-- > 0;) {
    const float sum = 1.0F + coarseFraction;
    up_.dispatch(sizeOf(levels_[i].up), {.size = sizeOf(levels_[i].up),
                                         .coarseSize = sizeOf(*coarse),
                                         .fraction = glm::vec2(1.0F, coarseFraction) / sum,
                                         .coarse = *coarse,
                                         .fine = levels_[i].down,
                                         .sum = levels_[i].up});
    coarse = &levels_[i].up;
    coarseFraction = sum;
  }
  return *coarse;
}

}  // namespace simreel::draw
