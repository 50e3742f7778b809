#include "golden/compare/filter.hpp"

#include <cmath>

namespace simreel::golden {

HalfKernel gaussianKernel(double sigma, int radius, double minimum) {
  std::vector<double> weights;
  double sum = 0;
  for (int x = 0; x <= radius; ++x) {
    weights.push_back(std::exp(-x * x / (2 * sigma * sigma)));
    sum += weights.back() * (x == 0 ? 1 : 2);
  }
  HalfKernel kernel;
  for (const double weight : weights)
    if (weight >= minimum) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

}  // namespace simreel::golden
