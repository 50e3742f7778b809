#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

namespace simreel::draw {

struct SurfaceBox;
struct ListCells;

/// Finds, on the GPU, the lamp shadow maps in which each surface may be visible. Uses the bounding box of
/// the surface's vertices. Most surfaces are visible in one or two of a lamp's six maps. Skipping the other
/// maps pays because software drivers transform vertices on a single thread.
class SurfaceCells {
 public:
  /// `cells`: number of shadow maps, six for each lamp with shadows. `lampDefines`: result of
  /// Lamps::shadowDefines().
  SurfaceCells(int cells, const gl::Defines& lampDefines);

  /// Finds the maps of all surfaces. The lamps must be bound.
  void find(const std::vector<sim::Surface>& surfaces);
  /// Draws the surface with index i, as one instance for each map that may show it. A program that includes
  /// glsl/draw/lights/lamp_surface.vert must be in use, and vertices and indices must be bound.
  void draw(const gl::Program& program, std::size_t i) const;

 private:
  void resize(std::size_t surfaces);
  void copyCounts(const std::vector<sim::Surface>& surfaces) const;
  void growBox(const sim::Surface& surface, int number);

  int cells_;
  gl::Kernels<SurfaceBox> box_;
  gl::Kernel<ListCells> list_;
  std::size_t capacity_ = 0;  ///< number of surfaces
  gl::Buffer boxes_, cellNumbers_, arguments_;
  gl::Texture cellView_;
};

}  // namespace simreel::draw
