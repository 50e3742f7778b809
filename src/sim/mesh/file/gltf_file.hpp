#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <filesystem>
#include <string_view>

namespace simreel::sim {

/// Triangles (also strips and fans) of the default scene of a glTF 2.0 or GLB file with this text:
/// positions, normals and the first texture coordinates, v downwards. Buffers lie in the text or in files
/// beside `file`. Everything is counted before it is allocated: each list against the bytes that hold it,
/// nodes as the tree that they have to be, vertices over all nodes. Throws UserError as loadMesh() does,
/// also for required extensions that change the mesh.
[[nodiscard]] Mesh readGltf(const std::filesystem::path& file, std::string_view text, MeshNormals normals);

}  // namespace simreel::sim
