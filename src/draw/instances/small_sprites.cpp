#include "draw/instances/small_sprites.hpp"

#include "draw/draw_state.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>

namespace simreel::draw {

struct PrepareSprites {
  static constexpr auto file = "draw/instances/small_sprites.comp";
  struct Variant {
    gl::Flag<"GLOW"> glow;
    gl::Flag<"FOR_LIGHT"> forLight;
    gl::Flag<"REFLECTIVE"> reflective;
    gl::Flag<"TRANSLUCENT"> translucent;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"light"> sunPlace = {};
  gl::Ambient<"shadowMap"> sunMap = {};
  gl::Ambient<"LampBlock"> lampBlock = {};
  gl::Ambient<"lampMembers"> lamps = {};
  gl::Ambient<"lampCells"> lampCells = {};
  gl::Ambient<"lampShadows"> lampShadows = {};
  SpriteFields all;
  gl::Out<"SpriteBlock"> sprites;
  gl::Uniform<"invocations", int> invocations;
};

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

SmallSprites::SmallSprites(const gl::Defines& lighting) : unlit_(gl::Defines()), lit_(lighting) {}

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

void SmallSprites::prepare(const Kind& kind, const SpriteFields& all, int capacity) {
  constexpr int maxInvocations = 1 << 20;
  if (capacity > capacity_) {
    view_ = {};
    memory_ = gl::Buffer("small sprites", static_cast<std::size_t>(capacity) * 16);
    view_ = gl::Texture::view("small sprites", GL_RGBA32UI, memory_);
    capacity_ = capacity;
  }
  const int invocations = std::min(capacity, maxInvocations);
  const bool lit = kind.use == Use::ball;
  (lit ? lit_ : unlit_)
      .of({.glow = kind.use == Use::glow,
           .forLight = kind.use == Use::shadow,
           .reflective = lit && kind.reflective,
           .translucent = lit && kind.translucent})
      .dispatch(invocations, {.all = all, .sprites = memory_, .invocations = (invocations + 63) / 64 * 64});
  gl::barrier();
  view_.bind(spriteUnit);
}

}  // namespace simreel::draw
