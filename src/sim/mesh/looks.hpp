#pragma once
#include "scene/scene.hpp"
#include "sim/mesh/file.hpp"

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

/// What of the materials that looksOf() shows is not drawn, in one line; empty where all is.
[[nodiscard]] std::string ignoredLooks(const scene::Object& object, const Mesh& mesh);

}  // namespace simreel::sim
