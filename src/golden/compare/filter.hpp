#pragma once
#include "golden/compare/four.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace simreel::golden {

/// One half of a symmetric or antisymmetric filter kernel: weights at distances of 0, 1, 2, ... pixels.
using HalfKernel = std::vector<float>;

/// Returns the Gaussian exp(-x^2 / (2 sigma^2)) for x = 0 to radius, normalized so that the whole kernel
/// sums to 1. Leaves out weights below `minimum` times the centre weight.
[[nodiscard]] HalfKernel gaussianKernel(double sigma, int radius, double minimum = 0);

/// Number of values that filters compute at a time. Filters therefore read and write beyond the end of a
/// row, up to a multiple of this number.
inline constexpr int filterStep = 32;

/// Rows of floats with padding, so that the last step of a filter may exceed the row.
class Rows {
 public:
  Rows(int count, int width)
      : stride_((std::size_t(width) + 2 * filterStep - 1) / filterStep * filterStep),
        values_(std::size_t(count) * stride_) {}
  [[nodiscard]] float* row(int index) { return values_.data() + std::size_t(index) * stride_; }
  [[nodiscard]] const float* row(int index) const { return values_.data() + std::size_t(index) * stride_; }
  [[nodiscard]] std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(stride_); }

 private:
  std::size_t stride_;
  std::vector<float> values_;
};

/// Formula that applies a half kernel k to the values v around a position. v[0] is the value at the
/// position, and v[i] and v[-i] are the values at distance i.
enum class Shape {
  even,  ///< k[0] v[0] + sum over i of k[i] (v[i] + v[-i])
  odd,   ///< sum over i of k[i] (v[i] - v[-i])
  /// sum over i of k[i] ((v[i] + v[-i]) - 2 v[0]); an even kernel whose weights sum to 0, so the result is
  /// exactly 0 if v is constant
  bend,
};

/// One of several filters that read the same input.
struct Sum {
  const HalfKernel* kernel;
  float* out;
};

/// Filters in[x + i * step] into the output x of each sum, for x from 0 to width - 1, rounded up to a
/// multiple of filterStep. `step` is 1 to filter along a row and Rows::stride() to filter down the columns.
/// All kernels must have the same size.
template <Shape... shapes>
void filterRow(const float* in, std::ptrdiff_t step, int width,
               const std::array<Sum, sizeof...(shapes)>& sums) {
  constexpr std::size_t count = sizeof...(shapes);
  constexpr std::array<Shape, count> shapeOf = {shapes...};
  // Number of SIMD vectors per sum. It is so small that all sums stay in registers.
  constexpr std::size_t wide = count == 1 ? 8 : count == 2 ? 4 : 2;
  static_assert(filterStep % (4 * wide) == 0);
  const auto taps = static_cast<std::ptrdiff_t>(sums[0].kernel->size());
  for (int x = 0; x < width; x += 4 * int(wide)) {
    std::array<std::array<Four, wide>, count> total{};
    std::array<Four, wide> here;
    for (std::size_t w = 0; w < wide; ++w) {
      here[w] = load(in + x + 4 * w);
      for (std::size_t s = 0; s < count; ++s)
        if (shapeOf[s] == Shape::even) total[s][w] = (*sums[s].kernel)[0] * here[w];
    }
    for (std::ptrdiff_t i = 1; i < taps; ++i)
      for (std::size_t w = 0; w < wide; ++w) {
        const Four before = load(in + x + 4 * w - i * step), behind = load(in + x + 4 * w + i * step);
        const Four both = behind + before;
        for (std::size_t s = 0; s < count; ++s) {
          const float weight = (*sums[s].kernel)[std::size_t(i)];
          if (shapeOf[s] == Shape::even) total[s][w] += weight * both;
          if (shapeOf[s] == Shape::odd) total[s][w] += weight * (behind - before);
          if (shapeOf[s] == Shape::bend) total[s][w] += weight * (both - (here[w] + here[w]));
        }
      }
    for (std::size_t s = 0; s < count; ++s)
      for (std::size_t w = 0; w < wide; ++w) store(sums[s].out + x + 4 * w, total[s][w]);
  }
}

}  // namespace simreel::golden
