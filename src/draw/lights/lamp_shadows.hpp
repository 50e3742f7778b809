#pragma once
#include "draw/draw_state.hpp"
#include "draw/lights/lamps.hpp"
#include "draw/lights/surface_cells.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace simreel::draw {

/// Shadow maps of lamps: for each that casts shadows six, along the axes and against them, side by side in
/// one texture. The ground casts none, nor does what lies within a lamp's radius.
class LampShadows {
 public:
  /// Throws UserError(device) where the maps do not fit into a texture.
  explicit LampShadows(const Lamps& lamps);

  [[nodiscard]] bool on() const { return count_ > 0; }
  /// The lamps are up to date. `drawMore` draws what other passes have into map number `cell`, 0 to `cells`
  /// - 1; the texture is bound with its state set.
  void draw(const sim::Drawables& drawables, const std::function<void(int cells)>& drawMore);
  /// Makes the maps readable by shaders.
  void bind() const;

 private:
  [[nodiscard]] const gl::Program& programOf(const sim::Surface& surface) const;
  [[nodiscard]] const gl::Buffer& allIndices(glm::ivec2 grid);

  int count_;
  gl::Defines defines_;
  float softness_ = 0;
  gl::Program surface_;
  std::unique_ptr<SurfaceCells> cells_;
  mutable gl::Program deformed_;  ///< displaces the vertices; made when first needed
  gl::Texture maps_;
  gl::Framebuffer target_;
  VertexArray vertices_;
  std::map<std::pair<int, int>, gl::Buffer> indices_;  ///< of grids that have those of a row alone
};

}  // namespace simreel::draw
