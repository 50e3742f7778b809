#pragma once
#include "batch/plan/sweep_plan.hpp"

#include <string>
#include <vector>

namespace simreel::batch {

/// True if a job of the sweep has colours whose range is "auto".
[[nodiscard]] bool hasAutoRanges(const SweepPlan& plan, const std::string& text);

/// Returns overrides that give all jobs of a sweep the same ranges of colours, so that their pictures can
/// be compared: each end that is "auto" in some job becomes the extreme of those jobs. Simulates each of
/// these jobs once, on the current context. `text`: text of the scene. Throws UserError(usage) for a scene
/// with errors, and the errors of sim::World.
[[nodiscard]] std::vector<scene::Override> sharedRanges(const SweepPlan& plan, const std::string& text);

}  // namespace simreel::batch
