#include "wide.hpp"

namespace plain {

Wide::Wide(int width, int height, const Rule& rule)
    : cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      width_(width),
      height_(height),
      range_(static_cast<int>(rule.half.size() / 2)),
      rule_(rule),
      next_(cells.size()),
      columns_(static_cast<std::size_t>(width)) {
  for (const int half : rule.half) square_ = square_ && half == range_;
}

void Wide::direct(int rows) {
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < width_; ++x) {
      int count = 0;
      for (int dy = -range_; dy <= range_; ++dy) {
        const int half = rule_.half[static_cast<std::size_t>(dy + range_)];
        const std::uint8_t* around = row(y + dy);
        if (x >= half && x + half < width_)
          for (int dx = -half; dx <= half; ++dx) count += around[x + dx];
        else
          for (int dx = -half; dx <= half; ++dx) count += around[(x + dx + width_) % width_];
      }
      const std::size_t i = static_cast<std::size_t>(y) * width_ + x;
      next_[i] = next(cells[i], count);
    }
}

void Wide::stepDirect() {
  direct(height_);
  cells.swap(next_);
}

void Wide::stepRunning() {
  if (square_)
    runSquares();
  else
    runRows();
  cells.swap(next_);
}

void Wide::runSquares() {
  const int r = range_;
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
    std::uint8_t* to = &next_[static_cast<std::size_t>(y) * width_];
    for (int x = 0; x < width_; ++x) {
      to[x] = next(here[x], count);
      const int enter = x + r + 1, leave = x - r;
      count +=
          columns_[enter < width_ ? enter : enter - width_] - columns_[leave < 0 ? leave + width_ : leave];
    }
    for (int x = 0; x < width_; ++x) columns_[x] -= out[x];
  }
}

void Wide::runRows() {
  std::vector<int> counts(static_cast<std::size_t>(width_));
  for (int y = 0; y < height_; ++y) {
    for (int& count : counts) count = 0;
    for (int dy = -range_; dy <= range_; ++dy) {
      const std::uint8_t* around = row(y + dy);
      const int half = rule_.half[static_cast<std::size_t>(dy + range_)];
      int count = 0;
      for (int dx = -half; dx <= half; ++dx) count += around[(dx + width_) % width_];
      for (int x = 0; x < width_; ++x) {
        counts[x] += count;
        const int enter = x + half + 1, leave = x - half;
        count +=
            around[enter < width_ ? enter : enter - width_] - around[leave < 0 ? leave + width_ : leave];
      }
    }
    const std::uint8_t* here = row(y);
    std::uint8_t* to = &next_[static_cast<std::size_t>(y) * width_];
    for (int x = 0; x < width_; ++x) to[x] = next(here[x], counts[x]);
  }
}

}  // namespace plain
