#include "batch/pieces/piece_checks.hpp"

#include <functional>
#include <vector>

namespace simreel::batch {

namespace {

/// Of the simulation's checks, for the last piece, which goes on from its end.
std::filesystem::path checksFile(const PiecePlan& plan) {
  return plan.folder / "checks.part.json";
}

std::function<void(const golden::CheckResult&)> toldBy(frame::Progress& progress) {
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
  return Measurements(scene, plan.allFrames(), {checksFile(plan), checksFile(plan)}, toldBy(progress));
}

std::optional<Measurements> checksOfPiece(const PiecePlan& plan, std::size_t piece, scene::Scene& scene,
                                          frame::Progress& progress) {
  if (!progress.tellsEvents()) return std::nullopt;
  const bool last = piece + 1 == plan.pieces.size();
  if (!last) std::erase_if(scene.checks, [](const scene::Check& check) { return !isOfPicture(check); });
  if (scene.checks.empty()) return std::nullopt;
  // But for the last one's all of a piece's frames but the last are its own.
  std::vector<int> own = plan.pieces.at(piece).frames;
  if (!last) own.pop_back();
  // Checks of state want frames of all the run, "not-blank" has a picture of this piece's only.
  return Measurements(scene, last ? plan.allFrames() : own, {checksFile(plan), {}}, toldBy(progress), last);
}

}  // namespace simreel::batch
