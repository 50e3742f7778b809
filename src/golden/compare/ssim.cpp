#include "golden/compare/ssim.hpp"

#include "base/error.hpp"
#include "golden/compare/filter.hpp"
#include "golden/compare/tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace simreel::golden {

namespace {

constexpr int radius = 5;
constexpr float c1 = 0.01f * 255 * 0.01f * 255;
constexpr float c2 = 0.03f * 255 * 0.03f * 255;

const HalfKernel& window() {
  static const HalfKernel kernel = gaussianKernel(1.5, radius);
  return kernel;
}

/// Returns the index of position `i` in `count` values that are mirrored at both ends. The end values are
/// repeated: c b a | a b c | c b a.
int mirrored(int i, int count) {
  const int period = 2 * count, at = ((i % period) + period) % period;
  return std::min(at, period - 1 - at);
}

/// Range of window centres along one side of the picture. It contains all centres whose window is inside
/// the picture. If the side is shorter than a window, it contains every pixel.
struct Span {
  explicit Span(int side) : first(side > 2 * radius ? radius : 0), count(side - 2 * first) {}
  int first, count;
};

/// Computes the SSIM of one tile of window centres, one channel at a time.
class TileSsim {
 public:
  TileSsim(const frame::Image& a, const frame::Image& b, const Tile& tile);
  /// Returns the sum of the SSIM values of a channel.
  [[nodiscard]] double sum(int channel);

 private:
  /// Number of windowed sums. The sums of a, b, a^2 + b^2 and a b determine means, variances and
  /// covariance.
  static constexpr int mapCount = 4;

  void load(int channel);
  [[nodiscard]] double rowSum(int row);

  const frame::Image &a_, &b_;
  Tile tile_;
  std::vector<std::ptrdiff_t> columns_;
  std::array<Rows, mapCount> maps_;
  Rows down_, made_;
  std::vector<float> similar_;
};

TileSsim::TileSsim(const frame::Image& a, const frame::Image& b, const Tile& tile)
    : a_(a),
      b_(b),
      tile_(tile),
      maps_{Rows(tile.height + 2 * radius, tile.width + 2 * radius), maps_[0], maps_[0], maps_[0]},
      down_(1, tile.width + 2 * radius),
      made_(mapCount, tile.width),
      similar_(std::size_t(tile.width)) {
  for (int x = tile.x - radius; x < tile.x + tile.width + radius; ++x)
    columns_.push_back(std::ptrdiff_t{4} * mirrored(x, a.width));
}

void TileSsim::load(int channel) {
  for (int row = 0; row < tile_.height + 2 * radius; ++row) {
    const std::ptrdiff_t start =
        std::ptrdiff_t{4} * mirrored(tile_.y - radius + row, a_.height) * a_.width + channel;
    const std::uint8_t *fromA = a_.bytes.data() + start, *fromB = b_.bytes.data() + start;
    float *rowA = maps_[0].row(row), *rowB = maps_[1].row(row);
    float* __restrict squares = maps_[2].row(row), * __restrict product = maps_[3].row(row);
    const std::size_t count = columns_.size();
    for (std::size_t x = 0; x < count; ++x) {
      rowA[x] = fromA[columns_[x]];
      rowB[x] = fromB[columns_[x]];
    }
    for (std::size_t x = 0; x < count; ++x) {
      squares[x] = rowA[x] * rowA[x] + rowB[x] * rowB[x];
      product[x] = rowA[x] * rowB[x];
    }
  }
}

double TileSsim::rowSum(int row) {
  for (int map = 0; map < mapCount; ++map) {
    const Rows& rows = maps_[std::size_t(map)];
    filterRow<Shape::even>(rows.row(row + radius), rows.stride(), tile_.width + 2 * radius,
                           {{{&window(), down_.row(0)}}});
    filterRow<Shape::even>(down_.row(0) + radius, 1, tile_.width, {{{&window(), made_.row(map)}}});
  }
  const float *meanA = made_.row(0), *meanB = made_.row(1), *square = made_.row(2), *product = made_.row(3);
  float* __restrict similar = similar_.data();
  for (int x = 0; x < tile_.width; ++x) {
    // SSIM = (2 mA mB + C1)(2 sAB + C2) / ((mA^2 + mB^2 + C1)(sA^2 + sB^2 + C2)), with means m, variances
    // s^2 and covariance sAB of the window.
    const float both = meanA[x] * meanB[x], squares = meanA[x] * meanA[x] + meanB[x] * meanB[x];
    const float covariance = product[x] - both, variances = square[x] - squares;
    similar[x] = (2 * both + c1) * (2 * covariance + c2) / ((squares + c1) * (variances + c2));
  }
  return std::accumulate(similar_.begin(), similar_.end(), 0.0);
}

double TileSsim::sum(int channel) {
  load(channel);
  double sum = 0;
  for (int row = 0; row < tile_.height; ++row) sum += rowSum(row);
  return sum;
}

template <class RowValue>
double sumOfRows(int height, const RowValue& value) {
  std::vector<double> sums(static_cast<std::size_t>(height));
  forEachBand(height, [&](int first, int last) {
    for (int y = first; y < last; ++y) sums[std::size_t(y)] = value(y);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

double psnr(const frame::Image& a, const frame::Image& b) {
  SIMREEL_CHECK_EQ(a.width, b.width);
  SIMREEL_CHECK_EQ(a.height, b.height);
  const double squares = sumOfRows(a.height, [&](int y) {
    const std::uint8_t* rowA = a.bytes.data() + std::ptrdiff_t{4} * y * a.width;
    const std::uint8_t* rowB = b.bytes.data() + std::ptrdiff_t{4} * y * b.width;
    std::int64_t sum = 0;
    for (int x = 0; x < a.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const int difference = int{rowA[4 * x + c]} - int{rowB[4 * x + c]};
        sum += difference * difference;
      }
    return double(sum);
  });
  if (squares == 0) return std::numeric_limits<double>::infinity();
  const double mean = squares / (3.0 * a.width * a.height);
  return 10 * std::log10(255.0 * 255.0 / mean);
}

double ssim(const frame::Image& a, const frame::Image& b) {
  SIMREEL_CHECK_EQ(a.width, b.width);
  SIMREEL_CHECK_EQ(a.height, b.height);
  const Span across(a.width), down(a.height);
  std::vector<double> sums(std::size_t(tilesOver(across.count, down.count)), 0.0);
  forEachTile(across.count, down.count, [&](Tile tile) {
    tile.x += across.first;
    tile.y += down.first;
    double& sum = sums[std::size_t(tile.index)];
    if (equalAround(a, b, tile, radius)) {
      sum = 3.0 * tile.width * tile.height;
      return;
    }
    TileSsim of(a, b, tile);
    for (int channel = 0; channel < 3; ++channel) sum += of.sum(channel);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / (3.0 * across.count * down.count);
}

}  // namespace simreel::golden
