#pragma once
#include "batch/pieces/piece_plan.hpp"
#include "batch/sweep/measurements.hpp"
#include "frame/sink/progress.hpp"

#include <cstddef>
#include <optional>

namespace simreel::batch {

/// The scene's checks for who reads events, each told once by all steps together: of state by the
/// simulation, beyond its last frame by the last piece, of pictures by the piece whose own they are.
/// Nothing where nobody reads them or there are none. The scene, whose checks change, and `progress` have
/// to live longer.
[[nodiscard]] std::optional<Measurements> checksOfSimulation(const PiecePlan& plan, scene::Scene& scene,
                                                             frame::Progress& progress);
[[nodiscard]] std::optional<Measurements> checksOfPiece(const PiecePlan& plan, std::size_t piece,
                                                        scene::Scene& scene, frame::Progress& progress);

}  // namespace simreel::batch
