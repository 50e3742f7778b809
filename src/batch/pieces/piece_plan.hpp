#pragma once
#include "batch/render/render_job.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::batch {

/// One piece of a sequence of frames.
struct Piece {
  /// Frames to draw. In all pieces except the last, the last frame is the first frame of the next piece.
  std::vector<int> frames;
  /// Returns the first frame. The piece begins with the state at this frame. The first piece begins at the
  /// scene's start.
  [[nodiscard]] int first() const { return frames.front(); }
};

/// Plan of a sequence that is drawn in pieces. It is stored as plan.json in a folder next to the output,
/// with a copy of the scene.
struct PiecePlan {
  /// Folder of the plan, the checkpoints and the pieces. The path is not stored in plan.json.
  std::filesystem::path folder;
  std::string output;  ///< argument of -o as an absolute path
  /// Asset folders as absolute paths. The scene's own folder is first.
  std::vector<std::filesystem::path> assets;
  std::vector<scene::Override> overrides;
  std::string fields;  ///< argument of --fields; empty if field files are not written
  bool counts = true;
  std::vector<Piece> pieces;

  [[nodiscard]] std::filesystem::path planFile() const { return folder / "plan.json"; }
  [[nodiscard]] std::filesystem::path sceneFile() const { return folder / "scene.json"; }
  [[nodiscard]] std::vector<int> allFrames() const;
  /// wholeOutput() returns the output name of the whole sequence. pieceOutput() returns the name for one
  /// piece, with the same file names in the piece's folder.
  [[nodiscard]] frame::OutputName wholeOutput() const;
  [[nodiscard]] frame::OutputName pieceOutput(std::size_t piece) const;
  /// Returns the request for the pass that simulates without drawing and stores the state at the start of
  /// each piece.
  [[nodiscard]] RenderRequest simulation(const std::string& command) const;
  [[nodiscard]] RenderRequest drawing(std::size_t piece, const std::string& command) const;

 private:
  [[nodiscard]] std::string pieceOutputText(std::size_t piece) const;
};

/// Splits frames into pieces of equal length. Throws UserError(usage) if there are more pieces than frames.
[[nodiscard]] std::vector<Piece> splitFrames(const std::vector<int>& frames, std::size_t pieces);

[[nodiscard]] std::string planText(const PiecePlan& plan);
/// Reads plan.json in `folder`. Throws UserError(usage) with the file and the error in it.
[[nodiscard]] PiecePlan readPiecePlan(const std::filesystem::path& folder);

}  // namespace simreel::batch
