#pragma once
#include "draw/draw_state.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <functional>

namespace simreel::draw {

struct SurfaceBounds;
struct ShadowFit;

/// The sun's shadow map, orthographic, fitted on the GPU to what casts shadows. The ground casts none.
class ShadowPass {
 public:
  explicit ShadowPass(const scene::Sun& sun);

  /// Grows bounds (glsl/draw/instances/bounds.glsl) by what other passes draw.
  using GrowMore = std::function<void(const gl::Buffer& bounds)>;
  /// Bounds and light map; then draw() may be called, and bind() by the passes that read.
  void fit(const sim::Drawables& drawables, const GrowMore& growMore);
  /// `drawMore` draws into the map, which is bound with its state set.
  void draw(const sim::Drawables& drawables, const std::function<void()>& drawMore) const;
  /// Makes the map and its place in space readable by shaders.
  void bind() const;
  [[nodiscard]] bool on() const { return on_; }
  [[nodiscard]] glm::ivec2 size() const { return {map_.width(), map_.height()}; }
  /// Defines for shaders that include draw/surface/shadow_read.glsl; empty when there is no shadow.
  [[nodiscard]] const gl::Defines& defines() const { return defines_; }

 private:
  bool on_;
  float softness_;
  gl::Defines defines_;
  /// The program for a surface: the second displaces its vertices, and is made when first needed.
  [[nodiscard]] const gl::Program& drawOf(const sim::Surface& surface) const;

  gl::Kernels<SurfaceBounds> bounds_;
  gl::Kernel<ShadowFit> fit_;
  gl::Program draw_;
  mutable gl::Program deformedDraw_;
  gl::Buffer boundKeys_, light_;
  gl::Texture lightView_, map_;
  gl::Framebuffer target_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
