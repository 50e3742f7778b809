#pragma once
#include "golden/compare/four.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace simreel::golden {

/// Half of a symmetric or antisymmetric kernel: weights at the distances 0, 1, 2, ... pixels.
using HalfKernel = std::vector<float>;

/// exp(-x^2 / (2 sigma^2)) for x = 0 to radius, scaled so that the whole kernel's weights sum to 1. Those
/// below `least` of the middle's are left out, from the ends.
[[nodiscard]] HalfKernel gaussianKernel(double sigma, int radius, double least = 0);

/// Filters compute so many values at a time, and so read and write beyond a row's end.
inline constexpr int filterStep = 32;

/// Rows of floats, each with room for a filter's last step behind it.
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

/// What a kernel k makes of the values v[i] in steps before and behind a place, v[0] there.
enum class Shape {
  even,  ///< k[0] v[0] + sum of k[i] (v[i] + v[-i])
  odd,   ///< sum of k[i] (v[i] - v[-i])
  bend,  ///< sum of k[i] ((v[i] + v[-i]) - 2 v[0]): even, weights sum to 0; exactly 0 where v is constant
};

/// One sum of several over the same values.
struct Sum {
  const HalfKernel* kernel;
  float* out;
};

/// out[x] for x from 0 to width - 1 and on to the next multiple of filterStep, of in[x + i * step]: step 1
/// is along a row, Rows::stride() down the columns. Kernels must be of one size (an invariant).
template <Shape... shapes>
void filterRow(const float* in, std::ptrdiff_t step, int width,
               const std::array<Sum, sizeof...(shapes)>& sums) {
  constexpr std::size_t count = sizeof...(shapes);
  constexpr std::array<Shape, count> shapeOf = {shapes...};
  constexpr std::size_t wide = count == 1 ? 8 : count == 2 ? 4 : 2;  // so that sums stay in registers
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
