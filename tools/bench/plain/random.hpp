#pragma once
#include <cstdint>

namespace plain {

/// 31 random bits of a cell in a step: the first word of PCG3D, as our kernels have it.
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
