#pragma once
#include "kernels/source/scan.hpp"

#include <cstddef>
#include <deque>

namespace simreel::kernels {

/// Returns insertions that give the flat initializer lists of a file the braces and vectors of their types,
/// because Microsoft's compiler fills a type's numbers in order, and glslang does not:
/// "float m[2][2] = {1, 2, 3, 4}" becomes "{{1, 2}, {3, 4}}". A list whose items do not fit stays as it is.
[[nodiscard]] Edits nestedInitializers(const std::deque<Scan>& all, std::size_t file);

}  // namespace simreel::kernels
