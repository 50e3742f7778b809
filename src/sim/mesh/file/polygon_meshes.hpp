#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <filesystem>
#include <string_view>

namespace simreel::sim {

/// Reads a mesh from an OBJ's text, with the materials of its libraries. Faces without normals are smooth
/// within a smoothing group (`s`), where vertices are matched by index, and flat outside all groups. With
/// MeshNormals::shared, all faces are smooth.
[[nodiscard]] Mesh readObj(const std::filesystem::path& file, std::string_view text, MeshNormals normals);

/// Reads a mesh from an STL's bytes, binary or text. Corners with equal positions become one vertex.
/// Neighbouring faces are smooth up to an angle of 30 degrees, except at vertices with more than 256 faces.
[[nodiscard]] Mesh readStl(const std::filesystem::path& file, std::string_view bytes, MeshNormals normals);

/// Reads a mesh from a PLY's bytes: faces and triangle strips. If the file has no normals, the mesh is
/// smooth, with vertices matched by index.
[[nodiscard]] Mesh readPly(const std::filesystem::path& file, std::string_view text);

}  // namespace simreel::sim
