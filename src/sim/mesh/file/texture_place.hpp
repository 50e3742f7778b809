#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <array>
#include <functional>

namespace simreel::sim {

/// Names that a format gives to the maps of a material: colour, opacity, metallic-roughness, normals,
/// occlusion, emission.
using MapNames = std::array<const char*, 6>;

/// Removes the maps whose texture transform differs from the transform of the material's first map, because
/// a mesh has only one uv per vertex. Calls `without` with the name of each removed map.
void agreeOnPlace(MeshMaterial& material, const MapNames& names,
                  const std::function<void(const char*)>& without);

/// Applies the texture transform of each material's first map to the uvs of its triangles. No vertex may
/// belong to two materials.
void placeTextures(Mesh& mesh);

}  // namespace simreel::sim
