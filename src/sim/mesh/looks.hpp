#pragma once
#include "gl/buffer.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

/// Triangles of a mesh that share one material.
struct MeshLook {
  scene::Material material;
  Mesh mesh;  ///< the triangles; empty if the whole mesh has this material
};

/// Returns the materials that the mesh's file defines, in the file's order, each with its triangles. Empty
/// if the file defines none or the scene gives the object a material. Triangles without a material get the
/// object's. Throws UserError for an unreadable texture.
[[nodiscard]] std::vector<MeshLook> looksOf(const scene::Object& object, const Mesh& mesh);

/// Returns the fallback material if neither the scene nor the file defines one: the object's material, with
/// white colour if the mesh has vertex colours.
[[nodiscard]] scene::Material plainLook(const scene::Object& object, const Mesh& mesh);

/// Materials of a mesh whose vertices move: one surface per material, all sharing the vertices.
class MovingLooks {
 public:
  /// Throws the errors of looksOf().
  MovingLooks(const scene::Object& object, const Mesh& mesh);
  /// Adds one surface per material to `drawables`: copies of `surface` with their own indices and material.
  void publish(const Surface& surface, Drawables& drawables) const;

 private:
  struct Part {
    scene::Material material;
    gl::Buffer indices;  ///< triangle indices; empty: the whole mesh
    int indexCount = 0;
  };
  std::vector<Part> parts_;
};

/// Returns one line that lists the features of the mesh and its materials that are not drawn; empty if
/// everything is drawn.
[[nodiscard]] std::string ignoredLooks(const scene::Object& object, const Mesh& mesh);

}  // namespace simreel::sim
