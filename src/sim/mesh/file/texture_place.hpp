#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <array>
#include <functional>

namespace simreel::sim {

/// What a format calls the maps of a material: colour, opacity, metal and roughness, normals, occlusion,
/// light of its own.
using MapNames = std::array<const char*, 6>;

/// A mesh has one uv for all pictures of a material: takes off those that do not lie as the first of them
/// does, each told to `without`.
void agreeOnPlace(MeshMaterial& material, const MapNames& names,
                  const std::function<void(const char*)>& without);

/// Moves the uvs of the triangles of each material as its first map lies. No vertex has two materials.
void placeTextures(Mesh& mesh);

}  // namespace simreel::sim
