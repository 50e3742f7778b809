#pragma once
#include "sim/mesh/file.hpp"

#include <filesystem>
#include <string_view>

struct aiScene;

namespace simreel::sim {

/// Whether the text of an OBJ names a library of materials.
[[nodiscard]] bool namesMaterials(std::string_view text);

/// The materials of an OBJ's MTL as the library has read them, with pictures beside the file: Kd, Pr and Pm
/// or else Ks and Ns, Ke, d or Tr, map_Kd, norm (or bump and map_Bump where they hold normals), map_Ke and
/// map_d. A picture that is not there, or lies outside the mesh's folder, is refused as loadMesh() does.
void addLibraryMaterials(const std::filesystem::path& file, const aiScene& scene, Mesh& mesh);

}  // namespace simreel::sim
