#pragma once
#include "frame/image.hpp"

#include <cstddef>
#include <vector>

namespace simreel::golden {

/// Half of a symmetric or antisymmetric kernel: weights at the distances 0, 1, 2, ... pixels.
using HalfKernel = std::vector<float>;

/// exp(-x^2 / (2 sigma^2)) for x = 0 to radius, scaled so that the whole kernel's weights sum to 1.
[[nodiscard]] HalfKernel gaussianKernel(double sigma, int radius);

/// Rows of floats that filters run over. Rows and columns outside are those of the border.
class Rows {
 public:
  Rows(int count, int width) : width_(width), values_(std::size_t(count) * std::size_t(width)) {}
  [[nodiscard]] float* row(int index) { return values_.data() + std::size_t(index) * std::size_t(width_); }
  [[nodiscard]] const float* row(int index) const {
    return values_.data() + std::size_t(index) * std::size_t(width_);
  }

 private:
  int width_;
  std::vector<float> values_;
};

/// One row with `radius` more values on either side, copies of its ends.
class PaddedRow {
 public:
  PaddedRow(int width, int radius)
      : width_(width), radius_(radius), values_(std::size_t(width + 2 * radius)) {}
  [[nodiscard]] float* data() { return values_.data() + radius_; }
  [[nodiscard]] const float* data() const { return values_.data() + radius_; }
  /// To be called when the middle has been filled.
  void pad();

 private:
  int width_, radius_;
  std::vector<float> values_;
};

// Along a row, out[x], x from 0 to width - 1; `in` must be padded by the kernel's radius.
// Even: sum of k[i] (in[x + i] + in[x - i]), k[0] counted once.
// Odd:  sum of k[i] (in[x + i] - in[x - i]).
// Bend: sum of k[i] (in[x + i] - 2 in[x] + in[x - i]): an even kernel whose weights sum to 0, exactly 0
// where `in` is constant.
void filterEven(const float* in, int width, const HalfKernel& kernel, float* out);
void filterOdd(const float* in, int width, const HalfKernel& kernel, float* out);
void filterBend(const float* in, int width, const HalfKernel& kernel, float* out);

// The same down the columns, around row `middle` of `rows`. addEvenRows adds to `out`, scaled.
void addEvenRows(const Rows& rows, int middle, int width, const HalfKernel& kernel, float scale,
                 float* out);
void filterOddRows(const Rows& rows, int middle, int width, const HalfKernel& kernel, float* out);
void filterBendRows(const Rows& rows, int middle, int width, const HalfKernel& kernel, float* out);

/// First byte of a row; rows above and below the image are its first and last.
[[nodiscard]] const std::uint8_t* clampedRow(const frame::Image& image, int y);
/// Whether rows first - margin to last + margin - 1 are equal, byte by byte.
[[nodiscard]] bool equalRows(const frame::Image& a, const frame::Image& b, int first, int last, int margin);

}  // namespace simreel::golden
