#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "sim/drawable.hpp"
#include "sim/mesh_file.hpp"

#include <string>

namespace simreel::sim {

/// A mesh on the GPU as a Surface wants it: vec4 positions and normals, vec2 uvs (zero where the mesh has
/// none), 32-bit indices.
class MeshBuffers {
 public:
  MeshBuffers(const std::string& name, const Mesh& mesh);

  /// Everything but model, sides and material; the pointers live as long as this.
  [[nodiscard]] Surface surface() const;

 private:
  gl::Buffer positions_, normals_, uvs_, indices_;
  gl::Texture positionView_, normalView_, uvView_;
  int vertexCount_ = 0;
  int indexCount_ = 0;
};

}  // namespace simreel::sim
