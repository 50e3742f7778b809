#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <filesystem>
#include <string_view>

namespace simreel::sim {

/// Reads the triangles (also strips and fans) of the default scene of a glTF 2.0 or GLB file from its text:
/// positions, normals and texture coordinates, v downwards. Buffers are embedded or in files in the folder
/// of `file`. Before memory is allocated, checks that each list fits into the bytes that hold it, that the
/// nodes form trees, and that the number of vertices summed over all nodes is within the limit. Throws
/// UserError as loadMesh() does, also for required extensions that affect the mesh.
[[nodiscard]] Mesh readGltf(const std::filesystem::path& file, std::string_view text, MeshNormals normals);

}  // namespace simreel::sim
