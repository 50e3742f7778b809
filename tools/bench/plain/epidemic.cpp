#include "plain.hpp"
#include "random.hpp"

#include <utility>

namespace plain {

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

}  // namespace plain
