#include "draw/screen/targets.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace simreel::draw {

namespace {

constexpr GLenum lightFormat = GL_RGBA16F;
constexpr GLenum depthFormat = GL_DEPTH_COMPONENT32F;

std::vector<GLint> sampleCounts(GLenum format) {
  GLint number = 0;
  glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_NUM_SAMPLE_COUNTS, 1, &number);
  std::vector<GLint> counts(static_cast<std::size_t>(std::max(number, 0)));
  if (!counts.empty())
    glGetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_SAMPLES,
                          static_cast<GLsizei>(counts.size()), counts.data());
  return counts;
}

void checkSamples(int samples) {
  if (samples == 1) return;
  const auto colors = sampleCounts(lightFormat);
  const auto depths = sampleCounts(depthFormat);
  std::string list = "1";
  for (auto count = colors.rbegin(); count != colors.rend(); ++count) {
    if (*count <= 1 || std::find(depths.begin(), depths.end(), *count) == depths.end()) continue;
    if (*count == samples) return;
    list += fmt::format(", {}", *count);
  }
  fail(ExitCode::device,
       "this device does not support {} samples per pixel; set \"samples\" to {} (GL_MAX_SAMPLES is {})",
       samples, list, gl::limits().samples);
}

void checkSize(glm::ivec2 size) {
  const int max = gl::limits().textureSize;
  if (size.x < 1 || size.y < 1)
    fail(ExitCode::usage, "a picture of {}x{} pixels is empty; width and height must be at least 1", size.x,
         size.y);
  if (size.x > max || size.y > max)
    fail(ExitCode::device, "a picture of {}x{} pixels: this device draws up to {}x{} (GL_MAX_TEXTURE_SIZE)",
         size.x, size.y, max, max);
}

gl::Texture layer(const std::string& label, GLenum format, glm::ivec2 size, int samples) {
  return samples > 1 ? gl::Texture::multisampled(label, format, size.x, size.y, samples)
                     : gl::Texture::image(label, format, size.x, size.y);
}

}  // namespace

Picture::Picture(glm::ivec2 size) {
  checkSize(size);
  color = gl::Texture::image("picture", GL_RGBA8, size.x, size.y);
  framebuffer = gl::Framebuffer("picture", &color, nullptr);
}

Targets::Targets(glm::ivec2 size, int samples) {
  checkSamples(samples);
  light = layer("light", lightFormat, size, samples);
  depth = layer("depth", depthFormat, size, samples);
  scene = gl::Framebuffer("scene", &light, &depth);
}

void Targets::clear(bool lightToo) const {
  constexpr std::array<GLfloat, 4> none = {0, 0, 0, 0};
  constexpr GLfloat farthest = 1;
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  if (lightToo) glClearNamedFramebufferfv(scene.name(), GL_COLOR, 0, none.data());
  glClearNamedFramebufferfv(scene.name(), GL_DEPTH, 0, &farthest);
}

}  // namespace simreel::draw
