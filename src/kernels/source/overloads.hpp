#pragma once
#include "kernels/source/scan.hpp"

#include <cstddef>
#include <deque>
#include <string_view>

namespace simreel::kernels {

/// Returns overloads to insert after each definition of the function `name` in a file. The overloads accept
/// a vector instead of a scalar, and a 4x4 matrix instead of a smaller one. Microsoft's compiler truncates
/// such arguments implicitly. glslang truncates only vectors to shorter vectors.
[[nodiscard]] Edits shorteningOverloads(const Scan& scan, std::string_view name);

}  // namespace simreel::kernels
