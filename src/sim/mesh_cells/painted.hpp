#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/simulation.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh_cells/cells.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

struct MeshPaintKernel;

/// A mesh whose vertices have the colours of their cells' values, by a kernel from where the values are.
class PaintedMesh {
 public:
  /// `colors`: linear RGB, evenly from the lowest value of a range to the highest.
  PaintedMesh(const std::string& name, const Mesh& mesh, const MeshCells& cells,
              const std::vector<glm::vec3>& colors);

  /// Values are floats from `firstWord` of an RGBA32UI texel view on, one a cell. Waits for nothing.
  void paint(const gl::Texture& words, int firstWord, glm::vec2 range);

  /// Everything but model, sides and material; the pointers live as long as this.
  [[nodiscard]] Surface surface() const;
  /// Reads it back.
  [[nodiscard]] MeshTable table(const glm::mat4& model) const;

 private:
  int count_;
  MeshTopology topology_;
  gl::WordsArray rest_;
  gl::Buffer painted_, normals_;
  gl::Texture paintedView_, normalView_;
  gl::Vec4Array palette_;
  gl::Kernel<MeshPaintKernel> paint_;
};

}  // namespace simreel::sim
