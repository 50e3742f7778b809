#include "draw/screen/bloom_pass.hpp"

#include "base/ieee.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/common.hpp>

namespace simreel::draw {

namespace {

constexpr float maxLevels = 9.0F;

constexpr const char* layout = "rgba16f";

}  // namespace

BloomPass::BloomPass(const scene::Bloom& bloom, glm::ivec2 size, int samples)
    : on_(bloom.strength.moves() || bloom.strength.at(0) > 0),
      threshold_(bloom.threshold),
      // Level i spreads light over about 2^(i + 1) pixels.
      reach_(std::clamp(static_cast<float>(ieee::log2(static_cast<double>(bloom.radius) * size.y)), 1.0F,
                        maxLevels)) {
  if (!on_) return;
  first_ = ScreenProgram("draw/screen/bloom_first.glsl", layout, {{"SAMPLES", std::to_string(samples)}});
  down_ = ScreenProgram("draw/screen/bloom_down.glsl", layout);
  up_ = ScreenProgram("draw/screen/bloom_up.glsl", layout);
  for (int i = 0; i < static_cast<int>(std::ceil(reach_)); ++i) {
    size = (size + 1) / 2;
    levels_.push_back(
        {ScreenTarget("bloom down", GL_RGBA16F, size), ScreenTarget("bloom up", GL_RGBA16F, size)});
    if (std::max(size.x, size.y) <= 2) break;
  }
}

const gl::Texture& BloomPass::draw(const gl::Texture& light) const {
  const auto texel = [](const gl::Texture& t) {
    return 1.0F / glm::vec2(static_cast<float>(t.width()), static_cast<float>(t.height()));
  };
  first_.program().set("size", glm::ivec2(light.width(), light.height()));
  first_.program().set("threshold", threshold_);
  light.bind(sceneUnit);
  first_.fill(levels_[0].down);
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    down_.program().set("texel", texel(levels_[i - 1].down.texture));
    levels_[i - 1].down.texture.bind(sceneUnit);
    down_.fill(levels_[i].down);
  }
  // Each level has the same share, the last what is left of `reach_`.
  const float whole = std::min(reach_, static_cast<float>(levels_.size()));
  const gl::Texture* coarse = &levels_.back().down.texture;
  float coarseFraction = whole - static_cast<float>(levels_.size() - 1);
  for (std::size_t i = levels_.size() - 1; i-- > 0;) {
    const float sum = 1.0F + coarseFraction;
    up_.program().set("coarseTexel", texel(*coarse));
    up_.program().set("fraction", glm::vec2(1.0F, coarseFraction) / sum);
    coarse->bind(sceneUnit);
    levels_[i].down.texture.bind(bloomUnit);
    up_.fill(levels_[i].up);
    coarse = &levels_[i].up.texture;
    coarseFraction = sum;
  }
  return *coarse;
}

}  // namespace simreel::draw
