#include "batch/sweep/measurements.hpp"

#include "base/file.hpp"
#include "batch/sweep/job_result.hpp"
#include "frame/image.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace simreel::batch {

Measurements::Measurements(scene::Scene& scene, std::span<const int> drawn, CheckFiles files,
                           std::function<void(const golden::CheckResult&)> onResult, bool ends)
    : scene_(scene), files_(std::move(files)), onResult_(std::move(onResult)) {
  const auto isDrawn = [&](int frame) { return std::binary_search(drawn.begin(), drawn.end(), frame); };
  tested_ = scene.testFrames();
  // The check "not-blank" needs pictures, so frames that are not drawn are removed from the check's frames.
  for (scene::Check& check : scene.checks) {
    if (check.what != "not-blank" || check.frames.empty()) continue;
    std::erase_if(check.frames, [&](int frame) { return !isDrawn(frame); });
    tested_.insert(tested_.end(), check.frames.begin(), check.frames.end());
    if (check.frames.empty()) check.what.clear();
  }
  std::erase_if(scene.checks, [](const scene::Check& check) { return check.what.empty(); });
  std::erase_if(tested_, [&](int frame) { return !isDrawn(frame); });
  if (ends && !drawn.empty()) tested_.push_back(drawn.back());
  std::sort(tested_.begin(), tested_.end());
  tested_.erase(std::unique(tested_.begin(), tested_.end()), tested_.end());
}

void Measurements::begin(const sim::World& world) {
  checker_.emplace(scene_, world, tested_);
  wanted_ = checker_->frames();
  wanted_.insert(wanted_.end(), tested_.begin(), tested_.end());
  std::sort(wanted_.begin(), wanted_.end());
  if (!files_.earlier.empty()) checker_->resume(readChecks(files_.earlier));
  const auto earlier = checker_->results();
  reportedCount_ = earlier.size();
  for (const golden::CheckResult& result : earlier) reported_.insert({result.frame, result.what});
}

bool Measurements::wants(int frame) const {
  return std::binary_search(wanted_.begin(), wanted_.end(), frame);
}

void Measurements::made(const sim::World& world) {
  checker_->state(world.frame(), world);
  news();
  if (tested_.empty() || world.frame() != tested_.back()) return;
  quantities_.clear();
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    const scene::Object& object = scene_.objects[i];
    if (!object.parameters->measures()) continue;
    const auto table = object.parameters->quantities();
    const std::vector<double> values = world.object(i).measure();
    for (std::size_t q = 0; q < std::min(table.size(), values.size()); ++q)
      quantities_.push_back({fmt::format("{} of {}", table[q].name, object.name), table[q].unit,
                             world.frame(),
                             std::isfinite(values[q]) ? std::optional(values[q]) : std::nullopt});
  }
}

void Measurements::drawn(int frame, const frame::Image& image) {
  if (!std::binary_search(tested_.begin(), tested_.end(), frame)) return;
  checker_->picture(frame, image);
  drawn_.insert(frame);
  news();
}

void Measurements::evaluateExisting(const std::function<std::filesystem::path(int frame)>& fileOf) {
  const bool looks = std::any_of(scene_.checks.begin(), scene_.checks.end(),
                                 [](const scene::Check& check) { return check.what == "not-blank"; });
  for (const int frame : tested_) {
    if (!looks || drawn_.contains(frame)) continue;
    const std::filesystem::path file = fileOf(frame);
    const std::string bytes = readFile(file, "frame");
    checker_->picture(frame, frame::decodeImage(std::as_bytes(std::span(bytes)), file.string()));
  }
  news();
}

void Measurements::news() {
  const auto results = checker_->results();
  if (results.size() == reportedCount_) return;
  reportedCount_ = results.size();
  if (!files_.kept.empty()) writeFileAtomically(files_.kept, checksText(results), NameSync::later);
  if (!onResult_) return;
  for (const golden::CheckResult& result : results)
    if (reported_.insert({result.frame, result.what}).second) onResult_(result);
}

std::vector<golden::CheckResult> Measurements::checks() const {
  return checker_ ? checker_->results() : std::vector<golden::CheckResult>();
}

}  // namespace simreel::batch
