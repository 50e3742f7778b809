#pragma once
#include "batch/collect/sweep_tables.hpp"
#include "frame/image.hpp"

#include <optional>

namespace simreel::batch {

/// One picture of every job, reduced, below the values that made it. Of a full grid each column has one
/// value of the last parameter, and heads tell the values. Jobs that failed, or a check of which did, have
/// a red border; those without a picture are grey, and say their state.
[[nodiscard]] frame::Image contactSheet(const CollectedSweep& sweep, std::optional<int> frame);

}  // namespace simreel::batch
