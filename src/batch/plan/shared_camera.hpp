#pragma once
#include "batch/plan/sweep_plan.hpp"

#include <string>
#include <vector>

namespace simreel::batch {

/// Returns overrides that place one camera for all jobs of a sweep, so that their pictures can be compared:
/// it frames the objects of all jobs. Returns nothing if the scene places its camera, if a varied path
/// changes the camera or the picture's size, if no object is framed, or if the framing depends on how
/// objects move (sim::needsSurvey); then each job has the camera that its scene gives. `text`: text of the
/// scene. Throws UserError(usage) for a scene with errors.
[[nodiscard]] std::vector<scene::Override> sharedCamera(const SweepPlan& plan, const std::string& text);

}  // namespace simreel::batch
