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

/// Positions and unit normals, moved by `model`, which scales all directions alike; w counts for nothing.
[[nodiscard]] MeshTable placed(std::span<const glm::vec4> positions, std::span<const glm::vec4> normals,
                               const glm::mat4& model);

/// What stays of a mesh while it deforms: vec2 uvs (zero where it has none), colours if it has them and
/// 32-bit indices.
class MeshTopology {
 public:
  MeshTopology(const std::string& name, const Mesh& mesh);
  /// Everything of a surface but positions, normals, model, sides and material; the pointers live as long
  /// as this.
  [[nodiscard]] Surface surface() const;
  /// Reads back what a table has besides positions and normals.
  void complete(MeshTable& table) const;

 private:
  gl::Buffer uvs_, colors_, indices_;
  gl::Texture uvView_, colorView_;
  bool hasUvs_;
  int vertexCount_;
  int indexCount_;
};

/// A mesh on the GPU as a Surface wants it: vec4 positions and normals, and its topology.
class MeshBuffers {
 public:
  MeshBuffers(const std::string& name, const Mesh& mesh);

  /// Everything but model, sides and material; it is still, and the pointers live as long as this.
  [[nodiscard]] Surface surface() const;
  /// Reads all of it back.
  [[nodiscard]] MeshTable table(const glm::mat4& model) const;

 private:
  unsigned number_;
  MeshTopology topology_;
  gl::Buffer positions_, normals_;
  gl::Texture positionView_, normalView_;
};

}  // namespace simreel::sim
