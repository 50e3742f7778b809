#pragma once
#include <cstdint>

namespace plain {

/// Returns 31 random bits for a cell and step: the first word of PCG3D, as in simreel's kernels.
inline std::uint32_t randomOf(std::uint32_t cell, std::uint32_t step, std::uint32_t seed) {
  std::uint32_t x = cell * 1664525U + 1013904223U, y = step * 1664525U + 1013904223U,
                z = seed * 1664525U + 1013904223U;
  x += y * z;
  y += z * x;
  z += x * y;
  x ^= x >> 16U;
  y ^= y >> 16U;
  z ^= z >> 16U;
  x += y * z;
  return x >> 1U;
}

}  // namespace plain
