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

/// Which of the lamps' shadow maps each surface reaches into, found on the GPU by the box around its
/// vertices: software drivers transform vertices on one thread, and most surfaces reach into one or two
/// maps of a lamp's six.
class SurfaceCells {
 public:
  /// For `cells` maps; `lampDefines`: Lamps::shadowDefines().
  SurfaceCells(int cells, const gl::Defines& lampDefines);

  /// Finds them for all surfaces. The lamps are bound.
  void find(const std::vector<sim::Surface>& surfaces);
  /// Draws number i of them, an instance for each of its maps: the program, which includes
  /// glsl/draw/lights/lamp_surface.vert, is in use, its vertices and indices are bound.
  void draw(const gl::Program& program, std::size_t i) const;

 private:
  void resize(std::size_t surfaces);
  void copyCounts(const std::vector<sim::Surface>& surfaces) const;
  void growBox(const sim::Surface& surface, int number);

  int cells_;
  gl::Kernels<SurfaceBox> box_;
  gl::Kernel<ListCells> list_;
  std::size_t capacity_ = 0;  ///< surfaces
  gl::Buffer boxes_, cellNumbers_, arguments_;
  gl::Texture cellView_;
};

}  // namespace simreel::draw
