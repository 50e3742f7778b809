#pragma once
#include "kernels/source/scan.hpp"

#include <cstddef>
#include <deque>

namespace simreel::kernels {

/// Returns insertions that add braces and vector constructors to the flat initializer lists of a file. For
/// example, "float m[2][2] = {1, 2, 3, 4}" becomes "{{1, 2}, {3, 4}}". Microsoft's compiler assigns a flat
/// list to the scalars of a type in order, but glslang does not. A list whose items do not fit is not
/// changed.
[[nodiscard]] Edits nestedInitializers(const std::deque<Scan>& all, std::size_t file);

}  // namespace simreel::kernels
