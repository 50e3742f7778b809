#pragma once
#include <span>

namespace simreel::frame {

/// Summary of a set of measured values; all zero if the set is empty.
struct Statistics {
  int count = 0;
  double median = 0, p5 = 0, p95 = 0;  ///< percentiles, interpolated as in percentile()
  double mean = 0, min = 0, max = 0;
};

[[nodiscard]] Statistics statisticsOf(std::span<const double> values);

/// Returns the percentile of `sorted` at fraction `p` (0 to 1), linearly interpolated between the two
/// nearest values. The min is at 0 and the max at 1 (definition 7 of Hyndman and Fan 1996, the default of
/// NumPy and R). Returns 0 if `sorted` is empty.
[[nodiscard]] double percentile(std::span<const double> sorted, double p);

/// Values of a set that are greater than three times the median.
struct Outliers {
  double bound = 0;  ///< three times the median; greater values are outliers
  int count = 0;
  int worst = -1;  ///< index of the greatest outlier; -1 if none exist
};

[[nodiscard]] Outliers outliersOf(std::span<const double> values);

}  // namespace simreel::frame
