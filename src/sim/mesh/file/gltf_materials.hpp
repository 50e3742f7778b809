#pragma once
#include "sim/mesh/file/gltf_document.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace simreel::sim {

/// The materials of a glTF 2.0 file: metallic-roughness with its maps, and of the extensions
/// KHR_materials_emissive_strength, KHR_materials_clearcoat, KHR_materials_sheen and
/// KHR_materials_transmission, with it KHR_materials_ior and KHR_materials_volume, their numbers, and of
/// KHR_texture_transform what all textures of a material have alike.
struct GltfMaterials {
  std::vector<MeshMaterial> materials;
  std::vector<MeshImage> images;     ///< those that the materials use, as their files have them
  std::vector<std::string> ignored;  ///< what is not drawn: a key and whose it is
};

/// Throws as GltfDocument does.
[[nodiscard]] GltfMaterials readMaterials(const GltfDocument& document);

/// The number of the uvs (TEXCOORD_n) that a material's textures lie on, those of others being ignored.
[[nodiscard]] std::uint64_t uvSetOf(const GltfDocument& document, std::size_t material);

}  // namespace simreel::sim
