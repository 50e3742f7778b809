#pragma once
#include "sim/core/drawable.hpp"

#include <vector>

namespace simreel::sim {

/// Returns the values of a field's cells, x fastest, row 0 first: bits as 0 or 1, bytes as 0 to 255, floats
/// unchanged. Reads back the memory, so it waits for the GPU.
[[nodiscard]] std::vector<float> fieldValues(const Field& field);

}  // namespace simreel::sim
