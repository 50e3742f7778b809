#pragma once
#include "sim/core/simulation.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::frame {

/// Encodes a mesh as binary glTF 2.0 (Khronos, "glTF 2.0 specification", 4.4 and 5): one node, one mesh,
/// one primitive with positions, normals, optional texture coordinates and 32-bit indices. Double-sided
/// meshes also get a material. Units are metres, y is up, v = 0 is the top row of a texture. Drops vertices
/// that no triangle uses. `comments` become asset.extras.
[[nodiscard]] std::vector<std::byte> encodeGlb(const sim::MeshTable& mesh, const std::string& name,
                                               std::span<const std::string> comments);

}  // namespace simreel::frame
