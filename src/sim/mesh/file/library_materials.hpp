#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace simreel::sim {

/// Throws if an `mtllib` line of the mesh names a file outside the mesh's folder.
void checkLibrary(const std::filesystem::path& file, const std::string& line);

/// Adds the materials called `names` from the libraries in an OBJ's `mtllib` lines (one or several
/// libraries per line), with textures in the folder of the OBJ file.
/// - Keys: Kd, Pr and Pm (without Pr, Ns gives the roughness), Ke, d or Tr, map_Kd, norm (or bump and
///   map_Bump if the image is a normal map), map_Ke and map_d, with the options -s, -o, -clamp and, for
///   normals, -bm.
/// - A value of d below 1 gives a blended material; map_d cuts holes.
/// - Reported in Mesh::ignored: a library or texture that is missing or outside the mesh's folder, a
///   texture in another format, a name that no library defines, other options, and malformed numbers.
/// - A backslash in a path may stand for a slash.
void addLibraryMaterials(const std::filesystem::path& file, const std::vector<std::string>& libraries,
                         const std::vector<std::string>& names, Mesh& mesh);

}  // namespace simreel::sim
