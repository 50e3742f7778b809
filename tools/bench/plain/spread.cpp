#include "plain.hpp"

#include <utility>

namespace plain {

namespace {

/// 31 random bits of a cell in a step: the first word of PCG3D, as our kernels have it.
std::uint32_t randomOf(std::uint32_t cell, std::uint32_t step, std::uint32_t seed) {
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

}  // namespace

Epidemic::Epidemic(int side, std::vector<std::uint8_t> first)
    : cells(std::move(first)), side_(side), next_(cells) {}

void Epidemic::step(const std::uint32_t* infection, std::uint32_t recovery, std::uint32_t waning,
                    std::uint32_t step) {
  for (int y = 0; y < side_; ++y) {
    const std::uint8_t* row = &cells[std::size_t(y) * side_];
    const std::uint8_t* above = &cells[std::size_t((y + side_ - 1) % side_) * side_];
    const std::uint8_t* below = &cells[std::size_t((y + 1) % side_) * side_];
    for (int x = 0; x < side_; ++x) {
      const int l = x == 0 ? side_ - 1 : x - 1, r = x == side_ - 1 ? 0 : x + 1;
      const int n = (above[l] == 2) + (above[x] == 2) + (above[r] == 2) + (row[l] == 2) + (row[r] == 2) +
                    (below[l] == 2) + (below[x] == 2) + (below[r] == 2);
      const std::size_t at = std::size_t(y) * side_ + x;
      const std::uint32_t random = randomOf(std::uint32_t(at), step, 1);
      const std::uint8_t cell = row[x];
      next_[at] = std::uint8_t(cell == 1   ? (random < infection[n] ? 2 : 1)
                               : cell == 2 ? (random < recovery ? 3 : 2)
                                           : (random < waning ? 1 : 3));
    }
  }
  std::swap(cells, next_);
}

Wildfire::Wildfire(int side, std::vector<std::uint8_t> first, const float* chances, int burnSteps)
    : cells(std::move(first)), side_(side), burnSteps_(burnSteps), next_(cells) {
  for (int i = 0; i < 8; ++i) chances_[i] = chances[i];
}

void Wildfire::step(std::uint32_t step) {
  const auto burning = [](std::uint8_t cell) { return cell >= 2 && cell < 255; };
  for (int y = 0; y < side_; ++y) {
    const std::uint8_t* row = &cells[std::size_t(y) * side_];
    const std::uint8_t* above = &cells[std::size_t((y + side_ - 1) % side_) * side_];
    const std::uint8_t* below = &cells[std::size_t((y + 1) % side_) * side_];
    for (int x = 0; x < side_; ++x) {
      const std::size_t at = std::size_t(y) * side_ + x;
      std::uint8_t cell = row[x];
      if (cell == 1) {
        const int l = x == 0 ? side_ - 1 : x - 1, r = x == side_ - 1 ? 0 : x + 1;
        const std::uint8_t around[8] = {above[l], above[x], above[r], row[l],
                                        row[r],   below[l], below[x], below[r]};
        float spared = 1;
        for (int i = 0; i < 8; ++i)
          if (burning(around[i])) spared *= 1 - chances_[i];
        if (spared < 1 && float(randomOf(std::uint32_t(at), step, 1)) * (1.0F / 2147483648.0F) < 1 - spared)
          cell = std::uint8_t(burnSteps_ + 1);
      } else if (burning(cell)) {
        cell = cell == 2 ? 255 : std::uint8_t(cell - 1);
      }
      next_[at] = cell;
    }
  }
  std::swap(cells, next_);
}

}  // namespace plain
