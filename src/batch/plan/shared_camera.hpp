#pragma once
#include "batch/plan/sweep_plan.hpp"

#include <string>
#include <vector>

namespace simreel::batch {

/// Returns overrides that place one camera for all jobs of a sweep, so that their pictures can be compared.
/// The camera frames the objects of all jobs. In four cases, returns an empty list, so that each job uses
/// the camera of its scene: the scene places its camera, a varied path changes the camera or the picture's
/// size, no object is framed, or the framing depends on how objects move (sim::needsSurvey). `text`: text
/// of the scene. Throws UserError(usage) for a scene with errors.
[[nodiscard]] std::vector<scene::Override> sharedCamera(const SweepPlan& plan, const std::string& text);

}  // namespace simreel::batch
