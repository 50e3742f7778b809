#pragma once
#include "sim/core/drawable.hpp"

#include <vector>

namespace simreel::sim {

/// Values of a field's cells, x fastest, row 0 first: bits 0 or 1, bytes 0 to 255, floats bit for bit.
/// Reads the memory back, so it waits for the GPU.
[[nodiscard]] std::vector<float> fieldValues(const Field& field);

}  // namespace simreel::sim
