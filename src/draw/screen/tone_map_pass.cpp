#include "draw/screen/tone_map_pass.hpp"

#include "draw/frame_values.hpp"

#include <string>
#include <utility>

namespace simreel::draw {

namespace {

gl::Defines definesFor(const scene::Render& render, int samples, bool bloom) {
  gl::Defines defines = filmDefines(render);
  defines.emplace_back("SAMPLES", std::to_string(samples));
  if (bloom) defines.emplace_back("BLOOM", "1");
  return withFrame(std::move(defines));
}

}  // namespace

ToneMapPass::ToneMapPass(const scene::Render& render, int samples, bool bloom)
    : program_("draw/screen/tone_map.glsl", "rgba8", definesFor(render, samples, bloom),
               "draw/screen/tone_map.vert") {
  program_.program().checkUniformBlock("FrameBlock", sizeof(shader::Frame));
}

void ToneMapPass::draw(const gl::Texture& light, const Picture& picture, const gl::Texture* glow,
                       float strength) const {
  light.bind(sceneUnit);
  if (glow != nullptr) {
    glow->bind(bloomUnit);
    program_.program().set("bloomStrength", strength);
  }
  program_.fill(picture.color, picture.framebuffer);
}

}  // namespace simreel::draw
