#include "batch/pieces/piece_checks.hpp"

#include <functional>
#include <vector>

namespace simreel::batch {

namespace {

/// Returns the file for the results of the simulation's checks. The last piece continues from it.
std::filesystem::path checksFile(const PiecePlan& plan) {
  return plan.folder / "checks.part.json";
}

std::function<void(const golden::CheckResult&)> reportedBy(frame::Progress& progress) {
  return [&progress](const golden::CheckResult& check) {
    progress.check(check.what, check.frame, check.value, check.passed);
  };
}

bool isOfPicture(const scene::Check& check) {
  return check.what == "not-blank";
}

}  // namespace

std::optional<Measurements> checksOfSimulation(const PiecePlan& plan, scene::Scene& scene,
                                               frame::Progress& progress) {
  if (!progress.tellsEvents() || scene.checks.empty()) return std::nullopt;
  return Measurements(scene, plan.allFrames(), {checksFile(plan), checksFile(plan)}, reportedBy(progress));
}

std::optional<Measurements> checksOfPiece(const PiecePlan& plan, std::size_t piece, scene::Scene& scene,
                                          frame::Progress& progress) {
  if (!progress.tellsEvents()) return std::nullopt;
  const bool last = piece + 1 == plan.pieces.size();
  if (!last) std::erase_if(scene.checks, [](const scene::Check& check) { return !isOfPicture(check); });
  if (scene.checks.empty()) return std::nullopt;
  // In all pieces except the last, the last frame also belongs to the next piece.
  std::vector<int> own = plan.pieces.at(piece).frames;
  if (!last) own.pop_back();
  // Only the last piece evaluates checks of states, and they need the frames of the whole run. Other pieces
  // evaluate only "not-blank", which needs the pictures of the piece.
  return Measurements(scene, last ? plan.allFrames() : own, {checksFile(plan), {}}, reportedBy(progress),
                      last);
}

}  // namespace simreel::batch
