#pragma once
#include "kernels/source/scan.hpp"

#include <cstddef>
#include <deque>
#include <string_view>

namespace simreel::kernels {

/// Returns further functions, behind each definition of the function `name` in a file, that take a vector
/// for a number and a 4x4 matrix for a smaller one. Microsoft's compiler shortens such arguments; glslang
/// shortens only vectors to vectors.
[[nodiscard]] Edits shorteningOverloads(const Scan& scan, std::string_view name);

}  // namespace simreel::kernels
