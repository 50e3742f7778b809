#pragma once
#include "batch/pieces/piece_plan.hpp"

namespace simreel::batch {

/// Joins all pieces into one output. Compares the hash of every file with the manifest that lists the file.
/// A frame that two pieces have drawn must be equal in state, pixels and bytes. Then moves pictures, counts
/// and manifest to the paths that a single run would have written, with the same bytes, or makes a video.
/// Existing frames of the same run in the output remain. Finally removes the pieces' folder. An interrupted
/// join can be started again. Throws UserError(baselineMissing) if a frame is missing, UserError(different)
/// if data are not as expected, UserError(usage) if the pieces depend on the machine and come from
/// different machines, and UserError(inputOutput).
void joinPieces(const PiecePlan& plan);

}  // namespace simreel::batch
