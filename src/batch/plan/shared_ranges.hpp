#pragma once
#include "batch/plan/sweep_plan.hpp"

#include <string>
#include <vector>

namespace simreel::batch {

/// True if a job of the sweep has colours with the range "auto".
[[nodiscard]] bool hasAutoRanges(const SweepPlan& plan, const std::string& text);

/// Returns overrides that give all jobs of a sweep the same ranges of colours, so that their pictures can
/// be compared. An "auto" bound becomes the extreme value over all jobs with that bound. Simulates each
/// such job once, on the current context. `text`: text of the scene. Throws UserError(usage) for a scene
/// with errors, and the errors of sim::World.
[[nodiscard]] std::vector<scene::Override> sharedRanges(const SweepPlan& plan, const std::string& text);

}  // namespace simreel::batch
