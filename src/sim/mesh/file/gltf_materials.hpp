#pragma once
#include "sim/mesh/file/gltf_document.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace simreel::sim {

/// Materials of a glTF 2.0 file: metallic-roughness with its maps; the numeric factors of the extensions
/// KHR_materials_emissive_strength, _clearcoat, _sheen, _transmission, _ior and _volume (the last two only
/// together with _transmission); and KHR_texture_transform, if all textures of a material have the same
/// transform.
struct GltfMaterials {
  std::vector<MeshMaterial> materials;
  std::vector<MeshImage> images;     ///< encoded images that the materials use
  std::vector<std::string> ignored;  ///< features that are not drawn, each with its key and material
};

/// Reads the materials. Throws the errors of GltfDocument.
[[nodiscard]] GltfMaterials readMaterials(const GltfDocument& document);

/// Returns the set number n of the texture coordinates (TEXCOORD_n) that a material's textures use.
/// Textures with another set number are ignored.
[[nodiscard]] std::uint64_t uvSetOf(const GltfDocument& document, std::size_t material);

}  // namespace simreel::sim
