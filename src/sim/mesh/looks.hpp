#pragma once
#include "gl/buffer.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

/// Triangles of a mesh that share one material.
struct MaterialPart {
  scene::Material material;
  Mesh mesh;  ///< mesh of these triangles; empty if the whole mesh has this material
};

/// Returns the materials that the mesh's file defines, in file order, each with its triangles. Triangles
/// without a material get the object's material. Empty if the file defines no materials or the scene gives
/// the object a material. Throws UserError for an unreadable texture.
[[nodiscard]] std::vector<MaterialPart> looksOf(const scene::Object& object, const Mesh& mesh);

/// Returns the material for a mesh if neither the scene nor the file defines one: the object's material, in
/// white if the mesh has vertex colours.
[[nodiscard]] scene::Material fallbackMaterial(const scene::Object& object, const Mesh& mesh);

/// Materials of a mesh whose vertices move. Each material is one surface; all surfaces use the same
/// vertices.
class MovingMeshMaterials {
 public:
  /// Throws the errors of looksOf().
  MovingMeshMaterials(const scene::Object& object, const Mesh& mesh);
  /// Adds one surface per material to `drawables`: copies of `surface`, each with the indices and the
  /// material of its triangles.
  void publish(const Surface& surface, Drawables& drawables) const;

 private:
  struct Part {
    scene::Material material;
    gl::Buffer indices;  ///< triangle indices; empty for the whole mesh
    int indexCount = 0;
  };
  std::vector<Part> parts_;
};

/// Returns one line that lists the features of the mesh and its materials that are not drawn; empty if
/// everything is drawn.
[[nodiscard]] std::string ignoredLooks(const scene::Object& object, const Mesh& mesh);

}  // namespace simreel::sim
