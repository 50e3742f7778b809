#include "golden/compare/filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace simreel::golden {

// Every loop runs over a whole row for one weight, so that the compiler works on several pixels at a time.

HalfKernel gaussianKernel(double sigma, int radius) {
  std::vector<double> weights;
  double sum = 0;
  for (int x = 0; x <= radius; ++x) {
    weights.push_back(std::exp(-x * x / (2 * sigma * sigma)));
    sum += weights.back() * (x == 0 ? 1 : 2);
  }
  HalfKernel kernel;
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

void PaddedRow::pad() {
  float* const middle = data();
  std::fill(middle - radius_, middle, middle[0]);
  std::fill(middle + width_, middle + width_ + radius_, middle[width_ - 1]);
}

void filterEven(const float* in, int width, const HalfKernel& kernel, float* __restrict out) {
  for (int x = 0; x < width; ++x) out[x] = kernel[0] * in[x];
  for (int i = 1; i < static_cast<int>(kernel.size()); ++i) {
    const float weight = kernel[std::size_t(i)];
    for (int x = 0; x < width; ++x) out[x] += weight * (in[x + i] + in[x - i]);
  }
}

void filterOdd(const float* in, int width, const HalfKernel& kernel, float* __restrict out) {
  std::fill(out, out + width, 0.0f);
  for (int i = 1; i < static_cast<int>(kernel.size()); ++i) {
    const float weight = kernel[std::size_t(i)];
    for (int x = 0; x < width; ++x) out[x] += weight * (in[x + i] - in[x - i]);
  }
}

void filterBend(const float* in, int width, const HalfKernel& kernel, float* __restrict out) {
  std::fill(out, out + width, 0.0f);
  for (int i = 1; i < static_cast<int>(kernel.size()); ++i) {
    const float weight = kernel[std::size_t(i)];
    for (int x = 0; x < width; ++x) out[x] += weight * ((in[x + i] - in[x]) + (in[x - i] - in[x]));
  }
}

void addEvenRows(const Rows& rows, int middle, int width, const HalfKernel& kernel, float scale,
                 float* __restrict out) {
  const float* here = rows.row(middle);
  for (int x = 0; x < width; ++x) out[x] += scale * kernel[0] * here[x];
  for (int i = 1; i < static_cast<int>(kernel.size()); ++i) {
    const float weight = scale * kernel[std::size_t(i)];
    const float *above = rows.row(middle - i), *below = rows.row(middle + i);
    for (int x = 0; x < width; ++x) out[x] += weight * (below[x] + above[x]);
  }
}

void filterOddRows(const Rows& rows, int middle, int width, const HalfKernel& kernel,
                   float* __restrict out) {
  std::fill(out, out + width, 0.0f);
  for (int i = 1; i < static_cast<int>(kernel.size()); ++i) {
    const float weight = kernel[std::size_t(i)];
    const float *above = rows.row(middle - i), *below = rows.row(middle + i);
    for (int x = 0; x < width; ++x) out[x] += weight * (below[x] - above[x]);
  }
}

void filterBendRows(const Rows& rows, int middle, int width, const HalfKernel& kernel,
                    float* __restrict out) {
  std::fill(out, out + width, 0.0f);
  const float* here = rows.row(middle);
  for (int i = 1; i < static_cast<int>(kernel.size()); ++i) {
    const float weight = kernel[std::size_t(i)];
    const float *above = rows.row(middle - i), *below = rows.row(middle + i);
    for (int x = 0; x < width; ++x) out[x] += weight * ((below[x] - here[x]) + (above[x] - here[x]));
  }
}

const std::uint8_t* clampedRow(const frame::Image& image, int y) {
  return image.bytes.data() +
         std::size_t(std::clamp(y, 0, image.height - 1)) * std::size_t(image.width) * 4;
}

bool equalRows(const frame::Image& a, const frame::Image& b, int first, int last, int margin) {
  const int begin = std::max(0, first - margin), end = std::min(a.height, last + margin);
  return std::memcmp(clampedRow(a, begin), clampedRow(b, begin),
                     std::size_t(end - begin) * std::size_t(a.width) * 4) == 0;
}

}  // namespace simreel::golden
