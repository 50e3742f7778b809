#pragma once
#include "gl/buffer.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

/// The triangles of a mesh that have one material.
struct MeshLook {
  scene::Material material;
  Mesh mesh;  ///< empty where all of the mesh has it
};

/// How the file of an object's mesh says that it looks, in the order of its materials; empty where the file
/// says nothing or the scene gives the object a material. Triangles for which it says nothing are as
/// the object is. Throws UserError for a picture that cannot be read.
[[nodiscard]] std::vector<MeshLook> looksOf(const scene::Object& object, const Mesh& mesh);

/// What a mesh shows where neither the scene nor its file says: the object's material, of white where
/// vertices have colours.
[[nodiscard]] scene::Material plainLook(const scene::Object& object, const Mesh& mesh);

/// How a mesh looks whose vertices move: a surface of all of its vertices for each material.
class MovingLooks {
 public:
  /// Throws as looksOf() does.
  MovingLooks(const scene::Object& object, const Mesh& mesh);
  /// A surface for each, like this one but for its indices, material and, where the file says so, sides.
  void show(const Surface& surface, Drawables& drawables) const;

 private:
  struct Part {
    scene::Material material;
    gl::Buffer indices;  ///< none: all of the mesh
    int indexCount = 0;
  };
  std::vector<Part> parts_;
};

/// What of the materials that looksOf() shows is not drawn, in one line; empty where all is.
[[nodiscard]] std::string ignoredLooks(const scene::Object& object, const Mesh& mesh);

}  // namespace simreel::sim
