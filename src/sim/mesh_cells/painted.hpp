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

/// Mesh whose vertices are coloured by the values of their cells. A kernel reads the values on the GPU.
class PaintedMesh {
 public:
  /// `colors` are evenly spaced linear RGB stops, from the lowest value of a range to the highest.
  PaintedMesh(const std::string& name, const Mesh& mesh, const MeshCells& cells,
              const std::vector<glm::vec3>& colors);

  /// Colours the vertices. `words` is an RGBA32UI texel view with one float per cell, starting at
  /// `firstWord`. Does not wait.
  void paint(const gl::Texture& words, int firstWord, glm::vec2 range);

  /// Returns a surface whose model, sides and material are not set. Its pointers are valid while this
  /// object exists.
  [[nodiscard]] Surface surface() const;
  /// Reads the mesh back and transforms it by `model`.
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
