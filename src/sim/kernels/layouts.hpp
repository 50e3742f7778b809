#pragma once
#include "sim/core/state_layout.hpp"
#include "sim/kernels/plan.hpp"

namespace simreel::sim {

/// Returns the layout of a buffer's elements: (n), (rows, columns) or (layers, rows, columns) of them. A
/// buffer of fixed members alone is one element.
[[nodiscard]] StateLayout layoutOf(const PlannedBuffer& buffer);

/// Returns the layout of a texture's texels as KernelStore::words() holds them, with as many numbers as the
/// format has channels.
[[nodiscard]] StateLayout layoutOf(const PlannedTexture& texture);

}  // namespace simreel::sim
