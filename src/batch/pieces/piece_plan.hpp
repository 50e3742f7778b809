#pragma once
#include "batch/render/render_job.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::batch {

/// One piece of a sequence.
struct Piece {
  std::vector<int> frames;  ///< that it draws: its own, and but for the last piece the next one's first
  /// The first of its frames, whose state it begins with; that of the first piece is the scene's start.
  [[nodiscard]] int first() const { return frames.front(); }
};

/// A sequence that is drawn in pieces: plan.json in a folder beside the output, and the scene as it was.
struct PiecePlan {
  std::filesystem::path folder;               ///< of plan, checkpoints and pieces; not written
  std::string output;                         ///< as -o took it; absolute
  std::vector<std::filesystem::path> assets;  ///< absolute: the scene's own folder first
  std::vector<scene::Override> overrides;
  std::string fields;  ///< "npy", "pfm" or empty
  bool counts = true;
  std::vector<Piece> pieces;

  [[nodiscard]] std::filesystem::path planFile() const { return folder / "plan.json"; }
  [[nodiscard]] std::filesystem::path sceneFile() const { return folder / "scene.json"; }
  [[nodiscard]] std::vector<int> allFrames() const;
  /// What the whole is called; and a piece's own output, with the same names in a folder of its own.
  [[nodiscard]] frame::OutputName wholeOutput() const;
  [[nodiscard]] frame::OutputName pieceOutput(std::size_t piece) const;
  /// The pass that simulates without drawing, and leaves the states that pieces begin with.
  [[nodiscard]] RenderRequest simulation(const std::string& command) const;
  [[nodiscard]] RenderRequest drawing(std::size_t piece, const std::string& command) const;

 private:
  [[nodiscard]] std::string pieceOutputText(std::size_t piece) const;
};

/// Splits frames into pieces of equal length. Throws UserError(usage) where there are fewer than pieces.
[[nodiscard]] std::vector<Piece> splitFrames(const std::vector<int>& frames, std::size_t pieces);

[[nodiscard]] std::string planText(const PiecePlan& plan);
/// Throws UserError(usage) naming the file and what is wrong in it.
[[nodiscard]] PiecePlan readPiecePlan(const std::filesystem::path& folder);

}  // namespace simreel::batch
