#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace simreel::sim {

/// Refuses the mesh where a line `mtllib` of it names a file outside its folder.
void checkLibrary(const std::filesystem::path& file, const std::string& line);

/// The materials called `names` of the libraries that an OBJ's lines `mtllib` name, one or several a line,
/// with pictures beside the file: Kd, Pr and Pm (else a
/// roughness by Ns where Ks is there), Ke, d or Tr, map_Kd, norm (or bump and map_Bump where they hold
/// normals), map_Ke and map_d, with their options -s, -o, -clamp and of normals -bm. What is partly seen
/// through by d is blended; map_d cuts holes. A library or a picture that is not there, or lies outside the
/// mesh's folder, a picture of another format, a name that no library has, other options and numbers that
/// are none are among what is ignored. A backslash in a path may stand for a slash.
void addLibraryMaterials(const std::filesystem::path& file, const std::vector<std::string>& libraries,
                         const std::vector<std::string>& names, Mesh& mesh);

}  // namespace simreel::sim
