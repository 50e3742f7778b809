#pragma once
#include "sim/core/simulation.hpp"

#include <span>
#include <string>

namespace simreel::frame {

/// A mesh as an OBJ file, numbers as short as they read back the same; the comments are its first lines. v
/// counts from a picture's last row, as others read it.
[[nodiscard]] std::string encodeObj(const sim::MeshTable& mesh, std::span<const std::string> comments);

}  // namespace simreel::frame
