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

/// Shadow maps of the lamps, in one texture. Each lamp with shadows has six maps side by side, along the
/// positive and negative axes. The ground and objects within a lamp's radius cast no shadow.
class LampShadows {
 public:
  /// Throws UserError(device) if the maps do not fit into a texture.
  explicit LampShadows(const Lamps& lamps);

  [[nodiscard]] bool on() const { return count_ > 0; }
  /// Draws the shadow maps of the lamps as of their last update. `drawMore(cells)` draws the objects of
  /// other passes into the maps with indices 0 to cells - 1. The texture and the drawing state are already
  /// set when it is called.
  void draw(const sim::Drawables& drawables, const std::function<void(int cells)>& drawMore);
  /// Binds the maps for shaders.
  void bind() const;

 private:
  [[nodiscard]] const gl::Program& programOf(const sim::Surface& surface) const;
  [[nodiscard]] const gl::Buffer& allIndices(glm::ivec2 grid);

  int count_;
  gl::Defines defines_;
  float softness_ = 0;
  gl::Program surface_;
  std::unique_ptr<SurfaceCells> cells_;
  mutable gl::Program deformed_;  ///< program that displaces vertices; created on first use
  gl::Texture maps_;
  gl::Framebuffer target_;
  VertexArray vertices_;
  std::map<std::pair<int, int>, gl::Buffer> indices_;  ///< full index buffers of grids; the grid's buffer
                                                       ///< covers only one row
};

}  // namespace simreel::draw
