#include "frame/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace simreel::frame {

double percentile(std::span<const double> sorted, double p) {
  if (sorted.empty()) return 0;
  const double at = std::clamp(p, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(at));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (sorted[above] - sorted[below]) * (at - static_cast<double>(below));
}

Statistics statisticsOf(std::span<const double> values) {
  if (values.empty()) return {};
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  return {static_cast<int>(sorted.size()),
          percentile(sorted, 0.5),
          percentile(sorted, 0.05),
          percentile(sorted, 0.95),
          sum / static_cast<double>(sorted.size()),
          sorted.front(),
          sorted.back()};
}

Outliers outliersOf(std::span<const double> values) {
  Outliers found{3 * statisticsOf(values).median, 0, -1};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] <= found.bound) continue;
    ++found.count;
    if (found.worst < 0 || values[i] > values[static_cast<std::size_t>(found.worst)])
      found.worst = static_cast<int>(i);
  }
  return found;
}

}  // namespace simreel::frame
