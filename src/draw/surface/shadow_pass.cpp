#include "draw/surface/shadow_pass.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <array>

#include <glm/vec4.hpp>

namespace simreel::draw {

namespace {

constexpr int axes = 5;  // boundCount of glsl/draw/instances/bounds.glsl

gl::Texture makeMap(int size) {
  const int max = gl::limits().textureSize;
  if (size > max)
    fail(ExitCode::device,
         "a shadow map of {} texels a side: this device allows {} (GL_MAX_TEXTURE_SIZE); lower "
         "\"shadowSize\"",
         size, max);
  gl::Texture map = gl::Texture::image("shadow map", GL_DEPTH_COMPONENT32F, size, size);
  // The border texels hold no caster, so clamping to them finds light outside the map.
  glTextureParameteri(map.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(map.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTextureParameteri(map.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(map.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  return map;
}

}  // namespace

ShadowPass::ShadowPass(const scene::Sun& sun) : on_(sun.shadow), softness_(sun.shadowSoftness) {
  if (!on_) return;
  defines_ = {{"SHADOW", "1"}, {"SHADOW_TAPS", softness_ <= 2.0F ? "4" : "16"}};
  if (sun.diameter > 0) defines_.emplace_back("SUN_DISC", "1");
  bounds_ = gl::Program::compute("draw/surface/shadow_bounds.comp");
  fit_ = gl::Program::compute("draw/surface/shadow_fit.comp");
  draw_ = gl::Program::graphics("draw/surface/shadow.vert", "draw/surface/shadow.frag");
  std::array<GLuint, 2 * axes> empty{};
  std::fill_n(empty.begin(), axes, 0xffffffffU);
  boundKeys_ = gl::Buffer::of<GLuint>("shadow bounds", empty);
  light_ = gl::Buffer("light map", 5 * sizeof(glm::vec4));
  lightView_ = gl::Texture::view("light map", GL_RGBA32F, light_);
  map_ = makeMap(sun.shadowSize);
  target_ = gl::Framebuffer("shadow map", nullptr, &map_);
}

void ShadowPass::fit(const sim::Drawables& drawables, const std::function<void()>& growMore) const {
  constexpr int maxInvocations = 1 << 14;
  constexpr int verticesEach = 32;
  boundKeys_.bindStorage(boundsBinding);
  light_.bindStorage(lightBinding);
  for (const sim::Surface& surface : drawables.surfaces) {
    if (!castsShadow(surface)) continue;
    const int invocations =
        std::clamp((surface.vertexCount + verticesEach - 1) / verticesEach, 1, maxInvocations);
    const gl::Program& bounds = boundsOf(surface);
    bounds.set("vertexCount", surface.vertexCount);
    bounds.set("invocations", invocations);
    bounds.set("model", surface.model);
    bindPositions(surface, bounds);
    bindDeformation(surface);
    bounds.dispatch(invocations);
  }
  growMore();
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  fit_.dispatch(1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  lightView_.bind(lightUnit);  // instances are culled by it next; simulations bind other things there
}

void ShadowPass::draw(const sim::Drawables& drawables, const std::function<void()>& drawMore) const {
  constexpr GLfloat farthest = 1;
  DrawState{.depthTest = true, .cullBack = false, .depthOffset = true}.set();
  // A filter of r texels reads depths up to r + 1 texels of slope away.
  glPolygonOffset(1.5F + softness_, 4.0F);
  glClearNamedFramebufferfv(target_.name(), GL_DEPTH, 0, &farthest);
  target_.bind();
  lightView_.bind(lightUnit);
  for (const sim::Surface& surface : drawables.surfaces) {
    if (!castsShadow(surface)) continue;
    const gl::Program& shader = drawOf(surface);
    shader.set("model", surface.model);
    bindPositions(surface, shader);
    bindDeformation(surface);
    shader.use();
    vertices_.bind(*surface.indices);
    drawTriangles(surface);
  }
  drawMore();
}

const gl::Program& ShadowPass::boundsOf(const sim::Surface& surface) const {
  if (surface.deform == nullptr) return bounds_;
  if (!deformedBounds_)
    deformedBounds_ = gl::Program::compute("draw/surface/shadow_bounds.comp", {{"DEFORMED", "1"}});
  return deformedBounds_;
}

const gl::Program& ShadowPass::drawOf(const sim::Surface& surface) const {
  if (surface.deform == nullptr) return draw_;
  if (!deformedDraw_)
    deformedDraw_ =
        gl::Program::graphics("draw/surface/shadow.vert", "draw/surface/shadow.frag", {{"DEFORMED", "1"}});
  return deformedDraw_;
}

void ShadowPass::bind() const {
  if (!on_) return;
  lightView_.bind(lightUnit);
  map_.bind(shadowUnit);
}

}  // namespace simreel::draw
