#include "draw/screen/tone_map_pass.hpp"

namespace simreel::draw {

ToneMapPass::ToneMapPass(const scene::Render& render, int samples, bool bloom)
    : program_("rgba8", {.samples = samples, .bloom = bloom}, withFrame(filmDefines(render)),
               "draw/screen/tone_map.vert") {}

void ToneMapPass::draw(const gl::Texture& light, const Picture& picture, const gl::Texture* glow,
                       float strength) const {
  program_.fill(picture.color, picture.framebuffer,
                {.light = light,
                 .scattered = glow != nullptr ? gl::Resource(*glow) : gl::Resource(),
                 .bloomStrength = strength});
}

}  // namespace simreel::draw
