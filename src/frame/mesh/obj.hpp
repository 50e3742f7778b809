#pragma once
#include "sim/core/simulation.hpp"

#include <span>
#include <string>

namespace simreel::frame {

/// Encodes a mesh as OBJ. Each number is the shortest text that is read back exactly. `comments` are the
/// first lines. v = 0 is the bottom row of a texture, as usual for OBJ.
[[nodiscard]] std::string encodeObj(const sim::MeshTable& mesh, std::span<const std::string> comments);

}  // namespace simreel::frame
