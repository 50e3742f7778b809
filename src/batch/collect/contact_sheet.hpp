#pragma once
#include "batch/collect/sweep_tables.hpp"
#include "frame/image.hpp"

#include <optional>

namespace simreel::batch {

/// Returns one image that shows a reduced picture of every job and the job's values. If the jobs form a
/// full grid, each column shows one value of the last parameter, and headings show the values. Jobs that
/// failed or have a failed check have a red border. Jobs without a picture are grey and show their state.
[[nodiscard]] frame::Image contactSheet(const CollectedSweep& sweep, std::optional<int> frame);

}  // namespace simreel::batch
