#include "plain.hpp"
#include "random.hpp"

#include <utility>

namespace plain {

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
