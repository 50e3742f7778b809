#include "golden/compare/ssim.hpp"

#include "base/error.hpp"
#include "golden/compare/bands.hpp"
#include "golden/compare/filter.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace simreel::golden {

namespace {

constexpr int radius = 5;
constexpr float c1 = 0.01f * 255 * 0.01f * 255;
constexpr float c2 = 0.03f * 255 * 0.03f * 255;

/// Of one channel: a, b, a^2, b^2 and ab.
constexpr int mapCount = 5;
using Maps = std::array<Rows, mapCount>;

const HalfKernel& window() {
  static const HalfKernel kernel = gaussianKernel(1.5, radius);
  return kernel;
}

/// The maps of rows first - radius to last + radius - 1, filtered along the rows.
void filterAlong(const frame::Image& a, const frame::Image& b, int channel, int first, int last,
                 std::array<PaddedRow, mapCount>& padded, Maps& maps) {
  for (int y = first - radius; y < last + radius; ++y) {
    const std::uint8_t* fromA = clampedRow(a, y) + channel;
    const std::uint8_t* fromB = clampedRow(b, y) + channel;
    for (int x = 0; x < a.width; ++x) {
      const float valueA = fromA[4 * x], valueB = fromB[4 * x];
      padded[0].data()[x] = valueA;
      padded[1].data()[x] = valueB;
      padded[2].data()[x] = valueA * valueA;
      padded[3].data()[x] = valueB * valueB;
      padded[4].data()[x] = valueA * valueB;
    }
    for (std::size_t map = 0; map < mapCount; ++map) {
      padded[map].pad();
      filterEven(padded[map].data(), a.width, window(), maps[map].row(y - first + radius));
    }
  }
}

/// The sum of SSIM over one row.
double rowSum(const Maps& maps, int middle, int width, Rows& filtered) {
  for (int map = 0; map < mapCount; ++map) {
    std::fill(filtered.row(map), filtered.row(map) + width, 0.0f);
    addEvenRows(maps[std::size_t(map)], middle, width, window(), 1, filtered.row(map));
  }
  const float *meanA = filtered.row(0), *meanB = filtered.row(1);
  const float *squareA = filtered.row(2), *squareB = filtered.row(3), *product = filtered.row(4);
  double sum = 0;
  for (int x = 0; x < width; ++x) {
    // (2 mA mB + C1)(2 sAB + C2) / ((mA^2 + mB^2 + C1)(sA^2 + sB^2 + C2))
    const float both = meanA[x] * meanB[x];
    const float squares = meanA[x] * meanA[x] + meanB[x] * meanB[x];
    const float covariance = product[x] - both;
    const float variances = (squareA[x] - meanA[x] * meanA[x]) + (squareB[x] - meanB[x] * meanB[x]);
    sum += double((2 * both + c1) * (2 * covariance + c2) / ((squares + c1) * (variances + c2)));
  }
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
    const std::uint8_t *rowA = clampedRow(a, y), *rowB = clampedRow(b, y);
    std::int64_t sum = 0;
    for (int x = 0; x < a.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const int apart = int{rowA[4 * x + c]} - int{rowB[4 * x + c]};
        sum += apart * apart;
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
  const int width = a.width;
  std::vector<double> sums(std::size_t(a.height), 0.0);
  forEachBand(a.height, [&](int first, int last) {
    if (equalRows(a, b, first, last, radius)) {
      std::fill(sums.begin() + first, sums.begin() + last, 3.0 * width);
      return;
    }
    const Rows rows(last - first + 2 * radius, width);
    const PaddedRow row(width, radius);
    Maps maps = {rows, rows, rows, rows, rows};
    std::array<PaddedRow, mapCount> padded = {row, row, row, row, row};
    Rows filtered(mapCount, width);
    for (int channel = 0; channel < 3; ++channel) {
      filterAlong(a, b, channel, first, last, padded, maps);
      for (int y = first; y < last; ++y)
        sums[std::size_t(y)] += rowSum(maps, y - first + radius, width, filtered);
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / (3.0 * width * a.height);
}

}  // namespace simreel::golden
