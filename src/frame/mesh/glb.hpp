#pragma once
#include "sim/core/simulation.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::frame {

/// A mesh as a binary glTF 2.0 file (Khronos, "glTF 2.0 specification", 4.4 and 5): one node, one mesh, one
/// primitive with positions, normals, texture coordinates where there are some, and 32-bit indices; a
/// material where backs are seen. y is
/// up, metres, v counts from a picture's first row. Vertices that no triangle names are left out.
/// `comments` stand in asset.extras.
[[nodiscard]] std::vector<std::byte> encodeGlb(const sim::MeshTable& mesh, const std::string& name,
                                               std::span<const std::string> comments);

}  // namespace simreel::frame
