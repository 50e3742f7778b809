#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/simulation.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <span>
#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns positions and unit normals transformed by `model`, which must scale uniformly; w of the inputs
/// is ignored.
[[nodiscard]] MeshTable placed(std::span<const glm::vec4> positions, std::span<const glm::vec4> normals,
                               const glm::mat4& model);

/// GPU buffers of a deforming mesh that do not depend on the deformation: vec2 uvs (zero if the mesh has
/// none), vertex colours if the mesh has any, and 32-bit indices.
class MeshTopology {
 public:
  MeshTopology(const std::string& name, const Mesh& mesh);
  /// Returns a surface whose positions, normals, model, sides and material are not set. Its pointers are
  /// valid while this object exists.
  [[nodiscard]] Surface surface() const;
  /// Reads back all members of a table except positions and normals.
  void complete(MeshTable& table) const;

 private:
  gl::Buffer uvs_, colors_, indices_;
  gl::Texture uvView_, colorView_;
  bool hasUvs_;
  int vertexCount_;
  int indexCount_;
};

/// GPU buffers of a mesh in the layout of Surface: vec4 positions and normals, and the MeshTopology.
class MeshBuffers {
 public:
  MeshBuffers(const std::string& name, const Mesh& mesh);

  /// Returns a surface whose model, sides and material are not set. The surface is marked as still; its
  /// pointers are valid while this object exists.
  [[nodiscard]] Surface surface() const;
  /// Reads the whole mesh back and transforms it by `model`.
  [[nodiscard]] MeshTable table(const glm::mat4& model) const;

 private:
  unsigned number_;
  MeshTopology topology_;
  gl::Buffer positions_, normals_;
  gl::Texture positionView_, normalView_;
};

}  // namespace simreel::sim
