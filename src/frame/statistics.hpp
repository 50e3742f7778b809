#pragma once
#include <span>

namespace simreel::frame {

/// What a set of measured values looks like; all zero for no values.
struct Statistics {
  int count = 0;
  double median = 0, p5 = 0, p95 = 0;  ///< see percentile()
  double mean = 0, min = 0, max = 0;
};

[[nodiscard]] Statistics statisticsOf(std::span<const double> values);

/// The value below which the share `p` (0 to 1) of `sorted` lies: linear between the two nearest, with the
/// least at 0 and the greatest at 1 (definition 7 of Hyndman and Fan 1996, the default of NumPy and R).
/// 0 for no values.
[[nodiscard]] double percentile(std::span<const double> sorted, double p);

/// Values beyond three times the median.
struct Outliers {
  double bound = 0;  ///< three times the median
  int count = 0;
  int worst = -1;  ///< index of the greatest of them; -1: there is none
};

[[nodiscard]] Outliers outliersOf(std::span<const double> values);

}  // namespace simreel::frame
