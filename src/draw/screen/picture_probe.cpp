#include "draw/screen/picture_probe.hpp"

#include "base/hash.hpp"
#include "draw/draw_state.hpp"
#include "draw/surface/mip_levels.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/limits.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

struct ReadSamples {
  static constexpr auto file = "probe/samples.comp";
  struct Variant {
    gl::Range<"SAMPLES", 1, 64> samples;
  };
  gl::In<"light"> light;
  gl::In<"depth"> depth;
  gl::Out<"SampleBlock"> words;
  gl::Uniform<"size", glm::ivec2> size;
};

namespace {

constexpr glm::ivec2 size(64, 48);  // size of the test picture in pixels
constexpr glm::ivec2 imageSize(40, 36);
constexpr int triangles = 120;

/// Returns the pseudo-random number (-1 to 1) with index `n` of the sequence `kind`.
float number(unsigned kind, unsigned n) {
  return shader::signedUnit(shader::hash3({n, kind, 19}).x);
}

/// Returns random triangles of all sizes, with three vertices each (position and u, normal and v). Some
/// extend beyond the picture or behind the eye.
std::vector<glm::vec4> soup() {
  std::vector<glm::vec4> vertices;
  for (unsigned i = 0; i < 3 * triangles; ++i) {
    const unsigned triangle = i / 3;
    const float scales[] = {0.02F, 0.1F, 0.4F, 1.6F};
    const float scale = scales[triangle % 4];
    const glm::vec3 middle(1.5F * number(1, triangle), 1.2F * number(2, triangle),
                           -2 + 2 * number(3, triangle));
    const glm::vec3 corner(number(4, i), number(5, i), number(6, i));
    vertices.emplace_back(middle + scale * corner, 3 * number(7, i));
    vertices.emplace_back(number(8, i), number(9, i), 1 + 0.5F * number(10, i), 3 * number(11, i));
  }
  return vertices;
}

std::vector<std::uint8_t> imageBytes() {
  std::vector<std::uint8_t> bytes;
  for (unsigned i = 0; i < static_cast<unsigned>(4 * imageSize.x * imageSize.y); ++i)
    bytes.push_back(i % 4 == 3 ? 255 : static_cast<std::uint8_t>(shader::hash3({i, 12, 19}).x >> 24U));
  return bytes;
}

std::vector<float> imageFloats(int channels, bool positive) {
  std::vector<float> floats;
  for (unsigned i = 0; i < static_cast<unsigned>(channels * imageSize.x * imageSize.y); ++i)
    floats.push_back(positive ? 0.5F + 0.5F * number(13, i) : number(14, i));
  return floats;
}

/// Returns an sRGB texture with the mip levels of mip_levels.hpp.
gl::Texture pictureTexture() {
  gl::Texture made = gl::Texture::image("probe picture", GL_SRGB8_ALPHA8, imageSize.x, imageSize.y, 0);
  const auto bytes = imageBytes();
  GLint level = 0;
  const auto upload = [&](glm::ivec2 of, const std::vector<std::uint8_t>& rgba) {
    glTextureSubImage2D(made.name(), level++, 0, 0, of.x, of.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  };
  upload(imageSize, bytes);
  for (const MipLevel& below : mipLevels(imageSize, bytes)) upload(below.size, below.rgba);
  return made;
}

/// Returns a half-float texture with the driver's mip levels, as used by skins.
gl::Texture reliefTexture() {
  gl::Texture made = gl::Texture::image("probe relief", GL_RGBA16F, imageSize.x, imageSize.y, 0);
  made.wrap(GL_REPEAT);
  glTextureSubImage2D(made.name(), 0, 0, 0, imageSize.x, imageSize.y, GL_RGBA, GL_FLOAT,
                      imageFloats(4, false).data());
  glGenerateTextureMipmap(made.name());
  return made;
}

/// Returns a depth texture with bilinear comparison, like shadow maps.
gl::Texture depthTexture() {
  gl::Texture made = gl::Texture::image("probe depths", GL_DEPTH_COMPONENT32F, imageSize.x, imageSize.y);
  glTextureParameteri(made.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureSubImage2D(made.name(), 0, 0, 0, imageSize.x, imageSize.y, GL_DEPTH_COMPONENT, GL_FLOAT,
                      imageFloats(1, true).data());
  return made;
}

gl::Texture layer(const char* label, GLenum format, int samples) {
  return samples > 1 ? gl::Texture::multisampled(label, format, size.x, size.y, samples)
                     : gl::Texture::image(label, format, size.x, size.y);
}

/// Draws half of the triangles opaque and half with additive blending.
void drawTriangles(const gl::Framebuffer& target) {
  const auto vertices = gl::Buffer::of<glm::vec4>("probe vertices", soup());
  const auto view = gl::Texture::view("probe vertices", GL_RGBA32F, vertices);
  const gl::Texture picture = pictureTexture();
  const gl::Texture relief = reliefTexture();
  const gl::Texture depths = depthTexture();
  const auto program = gl::Program::graphics("probe/triangles.vert", "probe/triangles.frag");
  // Projection with a depth range of 0.1 to 8 and an aspect ratio of 4:3. The values are constants, because
  // the tangent function of libraries may round differently.
  program.set("projection",
              glm::mat4(1.2F, 0, 0, 0, 0, 1.6F, 0, 0, 0, 0, -1.0253165F, -1, 0, 0, -0.20253165F, 0));
  target.bind();
  constexpr GLfloat none[] = {0, 0, 0, 0};
  constexpr GLfloat farthest = 1;
  DrawState{}.set();
  glClearNamedFramebufferfv(target.name(), GL_COLOR, 0, none);
  glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &farthest);
  program.use();
  view.bind(positionUnit);
  picture.bind(albedoUnit);
  relief.bind(reliefUnit);
  depths.bind(shadowUnit);
  const VertexArray pulled;
  pulled.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3 * (triangles / 2));
  DrawState{.adding = true}.set();
  glDrawArrays(GL_TRIANGLES, 3 * (triangles / 2), 3 * (triangles / 2));
}

/// Returns the bytes of the encoded picture.
std::vector<std::uint32_t> finish(const gl::Texture& light, const gl::Defines& samples) {
  const gl::Texture color = gl::Texture::image("probe colours", GL_RGBA8, size.x, size.y);
  const gl::Framebuffer target("probe colours", &color, nullptr);
  const auto program = gl::Program::graphics("probe/finish.vert", "probe/finish.frag", samples);
  DrawState{.depthTest = false}.set();
  target.bind();
  program.use();
  light.bind(sceneUnit);
  const VertexArray pulled;
  pulled.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(size.x * size.y));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTextureImage(color.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size() * 4),
                    pixels.data());
  return pixels;
}

}  // namespace

std::string probePictures() {
  const int samples = gl::limits().samples >= 4 ? 4 : 1;
  const gl::Defines defines = {{"SAMPLES", std::to_string(samples)}};
  const gl::Texture light = layer("probe light", GL_RGBA16F, samples);
  const gl::Texture depth = layer("probe depth", GL_DEPTH_COMPONENT32F, samples);
  const gl::Framebuffer target("probe", &light, &depth);
  drawTriangles(target);
  const int count = size.x * size.y * samples;
  const gl::Buffer out("probe samples", 5 * sizeof(std::uint32_t) * static_cast<std::size_t>(count));
  const gl::Kernel<ReadSamples> reader({}, {.samples = samples});
  reader.dispatch(count, {.light = light, .depth = depth, .words = out, .size = size});
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<std::uint32_t> words = out.readAll<std::uint32_t>();
  const auto pixels = finish(light, defines);
  words.insert(words.end(), pixels.begin(), pixels.end());
  return hashHex(std::as_bytes(std::span(words))).substr(0, 16);
}

}  // namespace simreel::draw
