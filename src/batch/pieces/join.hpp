#pragma once
#include "batch/pieces/piece_plan.hpp"

namespace simreel::batch {

/// Joins all pieces into one output. Compares every file's hash with the manifest that lists the file. A
/// frame that two pieces have drawn must be equal in state, pixels and bytes. Then moves pictures, counts
/// and manifest to where a single run would have written them, with the same bytes (frames of the same run
/// that already lie there stay), or makes a video. Finally removes the pieces' folder. An interrupted join
/// can be started again. Throws UserError: baselineMissing if a frame is missing; different if data are not
/// as expected; usage if pieces depend on their machine and were made by different machines; inputOutput.
void joinPieces(const PiecePlan& plan);

}  // namespace simreel::batch
