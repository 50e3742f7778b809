#include "plain.hpp"

#include <utility>

namespace plain {

namespace {

/// Updates the cells of a row, except the first and the last.
void inner(const std::uint8_t* __restrict a, const std::uint8_t* __restrict h,
           const std::uint8_t* __restrict b, std::uint8_t* __restrict to, int width) {
  for (int x = 1; x < width - 1; ++x) {
    const auto n =
        std::uint8_t(a[x - 1] + a[x] + a[x + 1] + h[x - 1] + h[x + 1] + b[x - 1] + b[x] + b[x + 1]);
    to[x] = std::uint8_t(std::uint8_t(n == 3) | (std::uint8_t(n == 2) & h[x]));
  }
}

}  // namespace

Life::Life(int width, int height)
    : cells(std::size_t(width) * height), width_(width), height_(height), next_(cells) {}

void Life::step() {
  const auto cell = [&](const std::uint8_t* a, const std::uint8_t* h, const std::uint8_t* b, int l, int x,
                        int r) {
    const int n = a[l] + a[x] + a[r] + h[l] + h[r] + b[l] + b[x] + b[r];
    return std::uint8_t((n == 3) | ((n == 2) & h[x]));
  };
  for (int y = 0; y < height_; ++y) {
    const std::uint8_t* a = &cells[std::size_t((y + height_ - 1) % height_) * width_];
    const std::uint8_t* h = &cells[std::size_t(y) * width_];
    const std::uint8_t* b = &cells[std::size_t((y + 1) % height_) * width_];
    std::uint8_t* to = &next_[std::size_t(y) * width_];
    to[0] = cell(a, h, b, width_ - 1, 0, 1);
    inner(a, h, b, to, width_);
    to[width_ - 1] = cell(a, h, b, width_ - 2, width_ - 1, 0);
  }
  std::swap(cells, next_);
}

}  // namespace plain
