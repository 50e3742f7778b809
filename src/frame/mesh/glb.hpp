#pragma once
#include "frame/mesh/gltf_materials.hpp"
#include "sim/core/simulation.hpp"
#include "sim/world/shown_mesh.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::frame {

/// Encodes a mesh as binary glTF 2.0 (Khronos, "glTF 2.0 specification", 4.4 and 5). The file has one node
/// with the mesh, which has a primitive and a material for each part. It contains positions, normals and
/// 32-bit indices, and texture coordinates and linear colours if the mesh has them. Units are metres, y is
/// up, and v = 0 is the top row of a texture. Drops vertices that no triangle uses. Each entry of `copies`
/// becomes a further node with a mesh and the transforms of its copies (extension EXT_mesh_gpu_instancing;
/// _COLOR_0 holds the linear colours of the copies). `comments` are written to asset.extras.
[[nodiscard]] std::vector<std::byte> encodeGlb(const sim::MeshTable& mesh, const std::string& name,
                                               std::span<const std::string> comments,
                                               const sim::MeshLooks& looks = {},
                                               const SkinPicturesOf& skins = {},
                                               std::span<const sim::ShownCopies> copies = {});

}  // namespace simreel::frame
