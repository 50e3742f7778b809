#pragma once
#include "batch/pieces/piece_plan.hpp"
#include "batch/sweep/measurements.hpp"
#include "frame/sink/progress.hpp"

#include <cstddef>
#include <optional>

namespace simreel::batch {

/// These functions return the scene's checks for reporting as progress events. They return nullopt if the
/// scene has no checks or nothing reads progress events. Each check is reported once over all steps. The
/// simulation reports checks of states. The last piece reports checks of states after the simulation's last
/// frame. Each piece reports the checks of its pictures. The scene, whose checks are changed, and
/// `progress` must outlive the result.
[[nodiscard]] std::optional<Measurements> checksOfSimulation(const PiecePlan& plan, scene::Scene& scene,
                                                             frame::Progress& progress);
[[nodiscard]] std::optional<Measurements> checksOfPiece(const PiecePlan& plan, std::size_t piece,
                                                        scene::Scene& scene, frame::Progress& progress);

}  // namespace simreel::batch
