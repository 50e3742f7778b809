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

/// The sun's orthographic shadow map, fitted on the GPU to the casters. The ground casts no shadow.
class ShadowPass {
 public:
  explicit ShadowPass(const scene::Sun& sun);

  /// Callback that extends the bounds (glsl/draw/instances/bounds.glsl) so that they contain the casters of
  /// other passes.
  using GrowMore = std::function<void(const gl::Buffer& bounds)>;
  /// Computes the bounds and the map's transform. Must be called before draw() and bind().
  void fit(const sim::Drawables& drawables, const GrowMore& growMore);
  /// Draws the map. `drawMore` draws the casters of other passes into the map; the map is bound and the
  /// drawing state is set.
  void draw(const sim::Drawables& drawables, const std::function<void()>& drawMore) const;
  /// Binds the map and its transform for shaders.
  void bind() const;
  [[nodiscard]] bool on() const { return on_; }
  [[nodiscard]] glm::ivec2 size() const { return {map_.width(), map_.height()}; }
  /// Returns the defines of shaders that include draw/surface/shadow_read.glsl. Empty if the sun casts no
  /// shadow.
  [[nodiscard]] const gl::Defines& defines() const { return defines_; }

 private:
  bool on_;
  float softness_;
  gl::Defines defines_;
  /// Returns the program that draws a surface. The program that displaces vertices is created on first use.
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
