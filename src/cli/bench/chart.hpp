#pragma once
#include "cli/bench/report.hpp"

#include <string>

namespace simreel::cli {

/// The report as an SVG picture: for each row a bar of its stages' medians (on a GPU one for the GPU and
/// one for the CPU), up to the median frame, with whiskers from the 5th to the 95th percentile.
[[nodiscard]] std::string benchChart(const BenchReport& report);

}  // namespace simreel::cli
