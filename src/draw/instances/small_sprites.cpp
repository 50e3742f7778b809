#include "draw/instances/small_sprites.hpp"

#include "draw/draw_state.hpp"
#include "gl/context.hpp"

#include <algorithm>

namespace simreel::draw {

namespace {

gl::Defines definesOf(SmallSprites::Use use) {
  gl::Defines defines;
  if (use == SmallSprites::Use::glow) defines.emplace_back("GLOW", "1");
  if (use == SmallSprites::Use::shadow) defines.emplace_back("FOR_LIGHT", "1");
  return defines;
}

}  // namespace

bool SmallSprites::points() {
  return !gl::softwareDriver();
}

const gl::Program& SmallSprites::kernel(Use use, const gl::Defines& lighting) {
  gl::Defines defines = definesOf(use);
  if (use == Use::ball) defines.insert(defines.end(), lighting.begin(), lighting.end());
  std::string key;
  for (const auto& [name, value] : defines) key += name + " ";
  const auto found = kernels_.find(key);
  if (found != kernels_.end()) return found->second;
  return kernels_.emplace(key, gl::Program::compute("draw/instances/small_sprites.comp", defines))
      .first->second;
}

const gl::Program& SmallSprites::shader(Use use) {
  const auto found = shaders_.find(use);
  if (found != shaders_.end()) return found->second;
  gl::Defines defines = definesOf(use);
  if (points()) defines.emplace_back("POINT", "1");
  const char* fragments =
      use == Use::shadow ? "draw/surface/shadow.frag" : "draw/instances/small_sprite.frag";
  return shaders_
      .emplace(use, gl::Program::graphics("draw/instances/small_sprite.vert", fragments, defines))
      .first->second;
}

void SmallSprites::prepare(const gl::Program& kernel, int capacity) {
  constexpr int maxInvocations = 1 << 20;
  if (capacity > capacity_) {
    view_ = {};
    memory_ = gl::Buffer("small sprites", static_cast<std::size_t>(capacity) * 16);
    view_ = gl::Texture::view("small sprites", GL_RGBA32UI, memory_);
    capacity_ = capacity;
  }
  const int invocations = std::min(capacity, maxInvocations);
  kernel.set("invocations", (invocations + 63) / 64 * 64);
  memory_.bindStorage(spriteBinding);
  kernel.dispatch(invocations);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  view_.bind(spriteUnit);
}

}  // namespace simreel::draw
