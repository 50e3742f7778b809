#pragma once
#include "batch/pieces/piece_plan.hpp"
#include "gl/context.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::batch {

/// Whether the states that pieces begin with are there, and whole if they are read; whether a piece's
/// frames are, as its manifest says.
[[nodiscard]] bool isSimulated(const PiecePlan& plan, bool read = false);
[[nodiscard]] bool isDrawn(const PiecePlan& plan, std::size_t piece);

/// Simulates up to the last piece, going on where an earlier pass ended. Returns the signal that
/// interrupted it, or 0. Throws UserError.
[[nodiscard]] int simulatePieces(const PiecePlan& plan, const gl::Context& context,
                                 frame::Progress& progress, const std::string& command);
/// Draws a piece, or goes on with it. Throws UserError: usage also where the state that it begins with was
/// simulated by a driver whose numerics differ and matter, inputOutput also where another process draws it.
[[nodiscard]] int drawPiece(const PiecePlan& plan, std::size_t piece, const gl::Context& context,
                            frame::Progress& progress, const std::string& command,
                            const std::filesystem::path& scratch = {});

/// How pieces are made on this machine.
struct LocalPieces {
  std::size_t workers = 1;
  gl::ContextOptions on;          ///< may list devices: each worker takes the next
  bool ndjson = false;            ///< events of every piece on standard error
  std::filesystem::path scratch;  ///< a folder of this machine's own to draw in; empty: none
  std::string command;
};
/// The simulation, then all pieces beside each other. Returns the signal that interrupted it, or 0. Throws
/// UserError with what the first piece that failed said.
[[nodiscard]] int makePieces(const PiecePlan& plan, const LocalPieces& how);

}  // namespace simreel::batch
