#include "draw/tone_map_pass.hpp"

#include "draw/frame_values.hpp"

#include <string>

namespace simreel::draw {

ToneMapPass::ToneMapPass(int samples)
    : program_(gl::Program::graphics("draw/tone_map.vert", "draw/tone_map.frag",
                                     {{"SAMPLES", std::to_string(samples)}})) {
  program_.checkUniformBlock("FrameBlock", sizeof(shader::Frame));
}

void ToneMapPass::draw(const Targets& targets) const {
  DrawState{.depthTest = false, .cullBack = false, .depthOffset = false}.set();
  targets.picture.bind();
  targets.light.bind(0);
  program_.use();
  vertices_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace simreel::draw
