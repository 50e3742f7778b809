#pragma once
#include "batch/pieces/piece_plan.hpp"

namespace simreel::batch {

/// Makes one output of all pieces: every file's hash is compared with the manifest that lists it, and the
/// frame that two pieces have both drawn has to be the same in state, pixels and bytes; then pictures,
/// counts and manifest go to where one run would have written them, byte for byte as it would have (beside
/// frames of the same run that lie there), or a video is made of them; and the pieces' folder goes. Once it
/// has begun it may be begun again. Throws UserError: baselineMissing where a frame is missing, different
/// where something is not what it should be, usage where pieces that depend on their machine were made by
/// different ones, inputOutput.
void joinPieces(const PiecePlan& plan);

}  // namespace simreel::batch
