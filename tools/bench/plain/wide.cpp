#include "wide.hpp"

namespace plain {

Wide::Wide(int width, int height, const Rule& rule)
    : cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      width_(width),
      height_(height),
      rule_(rule),
      next_(cells.size()),
      columns_(static_cast<std::size_t>(width)) {}

void Wide::stepDirect() {
  const int r = rule_.range;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      int count = 0;
      for (int dy = -r; dy <= r; ++dy) {
        const std::uint8_t* row = &cells[static_cast<std::size_t>((y + dy + height_) % height_) * width_];
        if (x >= r && x + r < width_)
          for (int dx = -r; dx <= r; ++dx) count += row[x + dx];
        else
          for (int dx = -r; dx <= r; ++dx) count += row[(x + dx + width_) % width_];
      }
      const std::size_t i = static_cast<std::size_t>(y) * width_ + x;
      next_[i] = cells[i] != 0 ? count >= rule_.surviveMin && count <= rule_.surviveMax
                               : count >= rule_.bornMin && count <= rule_.bornMax;
    }
  cells.swap(next_);
}

void Wide::stepRunning() {
  const int r = rule_.range;
  const auto row = [&](int y) {
    return &cells[static_cast<std::size_t>((y + height_) % height_) * width_];
  };
  for (int x = 0; x < width_; ++x) columns_[x] = 0;
  for (int dy = -r; dy < r; ++dy)
    for (int x = 0; x < width_; ++x) columns_[x] += row(dy)[x];
  for (int y = 0; y < height_; ++y) {
    const std::uint8_t* in = row(y + r);
    const std::uint8_t* out = row(y - r);
    for (int x = 0; x < width_; ++x) columns_[x] += in[x];
    int count = 0;
    for (int dx = -r; dx <= r; ++dx) count += columns_[(dx + width_) % width_];
    const std::uint8_t* here = row(y);
    std::uint8_t* next = &next_[static_cast<std::size_t>(y) * width_];
    for (int x = 0; x < width_; ++x) {
      const int low = here[x] != 0 ? rule_.surviveMin : rule_.bornMin;
      const int high = here[x] != 0 ? rule_.surviveMax : rule_.bornMax;
      next[x] = count >= low && count <= high;
      const int enter = x + r + 1, leave = x - r;
      count +=
          columns_[enter < width_ ? enter : enter - width_] - columns_[leave < 0 ? leave + width_ : leave];
    }
    for (int x = 0; x < width_; ++x) columns_[x] -= out[x];
  }
  cells.swap(next_);
}

}  // namespace plain
