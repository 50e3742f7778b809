#pragma once
#include "batch/pieces/piece_plan.hpp"
#include "batch/sweep/measurements.hpp"
#include "frame/sink/progress.hpp"

#include <cstddef>
#include <optional>

namespace simreel::batch {

/// Return the scene's checks for a reader of progress events; nullopt without checks or without a reader.
/// All steps together report each check once: the simulation reports checks of states, the last piece also
/// those beyond the simulation's last frame, and each piece the checks of its own pictures. The scene,
/// whose checks are changed, and `progress` must outlive the result.
[[nodiscard]] std::optional<Measurements> checksOfSimulation(const PiecePlan& plan, scene::Scene& scene,
                                                             frame::Progress& progress);
[[nodiscard]] std::optional<Measurements> checksOfPiece(const PiecePlan& plan, std::size_t piece,
                                                        scene::Scene& scene, frame::Progress& progress);

}  // namespace simreel::batch
