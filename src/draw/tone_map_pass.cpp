#include "draw/tone_map_pass.hpp"

#include "draw/frame_values.hpp"

#include <string>

namespace simreel::draw {

namespace {

gl::Defines definesFor(int samples, bool bloom) {
  gl::Defines defines = {{"SAMPLES", std::to_string(samples)}};
  if (bloom) defines.emplace_back("BLOOM", "1");
  return defines;
}

}  // namespace

ToneMapPass::ToneMapPass(int samples, bool bloom)
    : program_(
          gl::Program::graphics("draw/tone_map.vert", "draw/tone_map.frag", definesFor(samples, bloom))) {
  program_.checkUniformBlock("FrameBlock", sizeof(shader::Frame));
}

void ToneMapPass::draw(const Targets& targets, const gl::Texture* glow, float strength) const {
  DrawState{.depthTest = false, .cullBack = false, .depthOffset = false}.set();
  targets.picture.bind();
  targets.light.bind(0);
  if (glow != nullptr) {
    glow->bind(1);
    program_.set("bloomStrength", strength);
  }
  program_.use();
  vertices_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace simreel::draw
