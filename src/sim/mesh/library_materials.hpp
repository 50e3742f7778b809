#pragma once
#include "sim/mesh/file.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// The libraries of materials (MTL) that the text of an OBJ names.
[[nodiscard]] std::vector<std::string> librariesOf(std::string_view text);

/// The materials called `names` of an OBJ's libraries, with pictures beside the file: Kd, Pr and Pm (else a
/// roughness by Ns where Ks is there), Ke, d or Tr, map_Kd, norm (or bump and map_Bump where they hold
/// normals), map_Ke and map_d, with their options -s, -o, -clamp and of normals -bm. What is partly seen
/// through by d is blended; map_d cuts holes. A library or a picture that is not there, or lies outside the
/// mesh's folder, other options and numbers that are none are among what is ignored.
void addLibraryMaterials(const std::filesystem::path& file, const std::vector<std::string>& libraries,
                         const std::vector<std::string>& names, Mesh& mesh);

}  // namespace simreel::sim
