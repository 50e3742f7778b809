#include "draw/bloom_pass.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/common.hpp>

namespace simreel::draw {

namespace {

constexpr float mostLevels = 9.0F;

gl::Texture layer(const char* label, glm::ivec2 size) {
  gl::Texture texture = gl::Texture::image(label, GL_RGBA16F, size.x, size.y);
  texture.wrap(GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

BloomPass::BloomPass(const scene::Bloom& bloom, glm::ivec2 size, int samples)
    : on_(bloom.strength.moves() || bloom.strength.at(0) > 0),
      threshold_(bloom.threshold),
      // Level i spreads light over about 2^(i + 1) pixels.
      reach_(std::clamp(std::log2(bloom.radius * static_cast<float>(size.y)), 1.0F, mostLevels)) {
  if (!on_) return;
  first_ = gl::Program::graphics("draw/screen.vert", "draw/bloom_first.frag",
                                 {{"SAMPLES", std::to_string(samples)}});
  down_ = gl::Program::graphics("draw/screen.vert", "draw/bloom_down.frag");
  up_ = gl::Program::graphics("draw/screen.vert", "draw/bloom_up.frag");
  for (int i = 0; i < static_cast<int>(std::ceil(reach_)); ++i) {
    size = (size + 1) / 2;
    Level level;
    level.down = layer("bloom down", size);
    level.up = layer("bloom up", size);
    level.downTarget = gl::Framebuffer("bloom down", &level.down, nullptr);
    level.upTarget = gl::Framebuffer("bloom up", &level.up, nullptr);
    levels_.push_back(std::move(level));
    if (std::max(size.x, size.y) <= 2) break;
  }
}

const gl::Texture& BloomPass::draw(const Targets& targets) const {
  const auto texel = [](const gl::Texture& t) {
    return 1.0F / glm::vec2(static_cast<float>(t.width()), static_cast<float>(t.height()));
  };
  const auto fill = [&](const gl::Framebuffer& target, const gl::Program& program) {
    target.bind();
    program.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
  };
  DrawState{.depthTest = false}.set();
  vertices_.bind();
  first_.set("size", glm::ivec2(targets.light.width(), targets.light.height()));
  first_.set("threshold", threshold_);
  targets.light.bind(0);
  fill(levels_[0].downTarget, first_);
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    down_.set("texel", texel(levels_[i - 1].down));
    levels_[i - 1].down.bind(0);
    fill(levels_[i].downTarget, down_);
  }
  // Each level has the same share, the last what is left of `reach_`.
  const float whole = std::min(reach_, static_cast<float>(levels_.size()));
  const gl::Texture* coarse = &levels_.back().down;
  float coarseShare = whole - static_cast<float>(levels_.size() - 1);
  for (std::size_t i = levels_.size() - 1; i-- > 0;) {
    const float sum = 1.0F + coarseShare;
    up_.set("coarseTexel", texel(*coarse));
    up_.set("share", glm::vec2(1.0F, coarseShare) / sum);
    coarse->bind(0);
    levels_[i].down.bind(1);
    fill(levels_[i].upTarget, up_);
    coarse = &levels_[i].up;
    coarseShare = sum;
  }
  return *coarse;
}

}  // namespace simreel::draw
