#pragma once
#include "batch/pieces/piece_plan.hpp"
#include "gl/context.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::batch {

/// isSimulated() returns true if the checkpoints with which the pieces begin exist. If `read` is true, it
/// also checks that they are not damaged. isDrawn() returns true if the piece's manifest lists all frames
/// of the piece.
[[nodiscard]] bool isSimulated(const PiecePlan& plan, bool read = false);
[[nodiscard]] bool isDrawn(const PiecePlan& plan, std::size_t piece);

/// Simulates up to the start of the last piece, or continues an earlier pass. Returns the signal that
/// interrupted it, or 0. Throws UserError.
[[nodiscard]] int simulatePieces(const PiecePlan& plan, const gl::Context& context,
                                 frame::Progress& progress, const std::string& command);
/// Draws a piece, or continues an interrupted attempt. Throws UserError(usage), also if the piece begins
/// with a state of another driver whose numerics differ and matter, and UserError(inputOutput), also if
/// another process is drawing the piece.
[[nodiscard]] int drawPiece(const PiecePlan& plan, std::size_t piece, const gl::Context& context,
                            frame::Progress& progress, const std::string& command,
                            const std::filesystem::path& scratch = {});

/// Settings for making pieces on this machine.
struct LocalPieces {
  std::size_t workers = 1;
  gl::ContextOptions on;  ///< device selection; if it lists several devices, each worker takes the next one
  bool ndjson = false;    ///< true to write events of all pieces to standard error as JSON lines
  std::filesystem::path scratch;  ///< scratch folder on a local disk to draw in; empty if none is used
  std::string command;
};
/// Runs the simulation and draws all pieces, in parallel where possible. Returns the signal that
/// interrupted the run, or 0. Throws UserError with the message of the first piece that failed.
[[nodiscard]] int makePieces(const PiecePlan& plan, const LocalPieces& how);

}  // namespace simreel::batch
