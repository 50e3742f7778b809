#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <filesystem>
#include <string_view>

namespace simreel::sim {

/// The mesh of an OBJ's text, with the materials of its libraries. Faces without normals are smooth within
/// a smoothing group (`s`), around each vertex by its number, and flat without one; with
/// MeshNormals::shared all are smooth.
[[nodiscard]] Mesh readObj(const std::filesystem::path& file, std::string_view text, MeshNormals normals);

/// The mesh of a PLY's bytes: its faces and triangle strips. Without normals it is smooth around each
/// vertex by its number.
[[nodiscard]] Mesh readPly(const std::filesystem::path& file, std::string_view text);

}  // namespace simreel::sim
