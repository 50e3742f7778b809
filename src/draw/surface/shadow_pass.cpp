#include "draw/surface/shadow_pass.hpp"

#include "base/error.hpp"
#include "draw/surface_fields.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/give.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <array>

#include <glm/vec4.hpp>

namespace simreel::draw {

struct SurfaceBounds {
  static constexpr auto file = "draw/surface/shadow_bounds.comp";
  struct Variant {
    gl::Flag<"DEFORMED"> deformed;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  PlacedSurface surface;
  gl::Uniform<"vertexCount", int> vertexCount;
  gl::Uniform<"invocations", int> invocations;
  gl::Shared<"BoundsBlock"> bounds;
};

struct ShadowFit {
  static constexpr auto file = "draw/surface/shadow_fit.comp";
  gl::Ambient<"FrameBlock"> frame = {};
  gl::InOut<"BoundsBlock"> bounds;
  gl::Out<"LightBlock"> light;
};

namespace {

constexpr int axes = 5;  // value of boundCount in glsl/draw/instances/bounds.glsl

gl::Texture makeMap(int size) {
  const int max = gl::limits().textureSize;
  if (size > max)
    fail(ExitCode::device,
         "a shadow map of {} texels a side: this device allows {} (GL_MAX_TEXTURE_SIZE); lower "
         "\"shadowSize\"",
         size, max);
  gl::Texture map = gl::Texture::image("shadow map", GL_DEPTH_COMPONENT32F, size, size);
  // No caster covers border texels that visible points read, so clamping gives full light outside the map.
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
  fit_ = gl::Kernel<ShadowFit>(gl::Defines());
  draw_ = gl::Program::graphics("draw/surface/shadow.vert", "draw/surface/shadow.frag");
  std::array<GLuint, 2 * axes> empty{};
  std::fill_n(empty.begin(), axes, 0xffffffffU);
  boundKeys_ = gl::Buffer::of<GLuint>("shadow bounds", empty);
  light_ = gl::Buffer("light map", 5 * sizeof(glm::vec4));
  lightView_ = gl::Texture::view("light map", GL_RGBA32F, light_);
  map_ = makeMap(sun.shadowSize);
  target_ = gl::Framebuffer("shadow map", nullptr, &map_);
}

void ShadowPass::fit(const sim::Drawables& drawables, const GrowMore& growMore) {
  constexpr int maxInvocations = 1 << 14;
  constexpr int verticesEach = 32;
  for (const sim::Surface& surface : drawables.surfaces) {
    if (!castsShadow(surface)) continue;
    const int invocations =
        std::clamp((surface.vertexCount + verticesEach - 1) / verticesEach, 1, maxInvocations);
    bounds_.of({.deformed = surface.deform != nullptr})
        .dispatch(invocations, {.surface = placed(surface),
                                .vertexCount = surface.vertexCount,
                                .invocations = invocations,
                                .bounds = boundKeys_});
  }
  growMore(boundKeys_);
  fit_.dispatch(1, {.bounds = boundKeys_, .light = light_});
  gl::barrier();
  lightView_.bind(lightUnit);  // The following instance culling reads the transform. Simulations bind other
                               // textures to this unit, so the transform must be bound again.
}

void ShadowPass::draw(const sim::Drawables& drawables, const std::function<void()>& drawMore) const {
  constexpr GLfloat farthest = 1;
  DrawState{.depthTest = true, .cullBack = false, .depthOffset = true}.set();
  // A shadow filter of r texels reads depths up to r + 1 texels away along a slope.
  glPolygonOffset(1.5F + softness_, 4.0F);
  glClearNamedFramebufferfv(target_.name(), GL_DEPTH, 0, &farthest);
  target_.bind();
  lightView_.bind(lightUnit);
  for (const sim::Surface& surface : drawables.surfaces) {
    if (!castsShadow(surface)) continue;
    const gl::Program& shader = drawOf(surface);
    gl::give(shader, placed(surface));
    shader.use();
    vertices_.bind(*surface.indices);
    drawTriangles(surface);
  }
  drawMore();
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
