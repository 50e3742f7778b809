#pragma once
#include "cli/bench/report.hpp"

#include <string>

namespace simreel::cli {

/// Returns the report as an SVG picture. Each row has a bar that consists of the median times of its
/// stages. On a GPU, each row has one bar for the GPU and one for the CPU. The bar is filled up to the
/// median frame time, and whiskers extend from the 5th to the 95th percentile.
[[nodiscard]] std::string benchChart(const BenchReport& report);

}  // namespace simreel::cli
