#include "golden/suite/suite.hpp"

#include "base/clock.hpp"
#include "golden/suite/blame.hpp"
#include "golden/suite/scene_test.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace simreel::golden {

namespace {

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

Outcome tryScene(const SceneFile& scene, const SuiteOptions& options, const Device& device, int attempt) {
  SceneTest test(scene, options, device, attempt);
  Outcome made;
  try {
    test.run();
  } catch (const UserError& error) {
    made.error = error.code();
    test.result().status = Status::error;
    const auto text = lines(error.what());
    auto& messages = test.result().messages;
    messages.insert(messages.end(), text.begin(), text.end());
  }
  made.hardFailed = test.hardFailed();
  made.scene = std::move(test.result());
  made.stale = std::move(test.stale());
  return made;
}

/// Adds the pictures of an earlier attempt to the frames of the last attempt.
void addEarlier(const std::vector<FrameResult>& frames, const std::string& attempt, SceneResult& result) {
  for (const FrameResult& from : frames) {
    if (from.actualImage.empty()) continue;
    auto to = std::find_if(result.frames.begin(), result.frames.end(),
                           [&](const FrameResult& frame) { return frame.frame == from.frame; });
    if (to == result.frames.end()) {
      to = result.frames.emplace(to);
      to->frame = from.frame;
      to->time = from.time;
      to->status = from.status;
    }
    if (from.others.empty()) to->others.push_back({attempt, from.actualImage});
    for (const OtherPicture& other : from.others)
      to->others.push_back({attempt + ", " + other.label, other.image});
    if (!from.differenceImage.empty())
      to->others.push_back({attempt + ", difference", from.differenceImage});
    if (to->expectedImage.empty() && from.others.empty()) to->expectedImage = from.expectedImage;
  }
}

bool mayPassOnRetry(Status status) {
  return status == Status::fail || status == Status::nondeterministic || status == Status::error;
}

/// Turns an expected failure into xfail, unless a pixel exceeds hardFail. Turns an unexpected pass into
/// xpass.
void applyExpectation(Outcome& made) {
  SceneResult& result = made.scene;
  if (result.xfail.empty()) return;
  if (result.status == Status::pass) {
    result.status = Status::xpass;
    result.messages.push_back("passes, though the scene expects it to fail (" + result.xfail +
                              "); remove its \"xfail\"");
  } else if (result.status == Status::fail && made.hardFailed) {
    result.notes.push_back("expected to fail, but hardFail is not excused by xfail");
  } else if (result.status == Status::fail) {
    result.status = Status::xfail;
  }
}

}  // namespace

void addAttempts(std::vector<Attempt> attempts, SceneResult& result, int losses) {
  if (attempts.empty()) return;
  attempts.insert(attempts.end(), result.attempts.begin(), result.attempts.end());
  result.attempts = std::move(attempts);
  if (result.status != Status::pass) return;
  const Attempt& first = result.attempts.front();
  result.status = Status::flaky;
  result.messages.push_back(
      fmt::format("passed on try {}; before that: {}", result.attempts.size() + std::size_t(losses) + 1,
                  first.messages.empty() ? statusName(first.status) : first.messages.front()));
}

Outcome testScene(const SceneFile& scene, const SuiteOptions& options, const Device& device, int losses) {
  const auto begin = Clock::now();
  std::vector<Attempt> attempts;
  std::vector<std::vector<FrameResult>> earlier;  // frames of the earlier attempts, whose pictures are
                                                  // added to the result
  int attempt = losses + 1;
  Outcome made = tryScene(scene, options, device, attempt);
  bool everHardFailed = made.hardFailed;
  while (made.scene.xfail.empty() && mayPassOnRetry(made.scene.status) && attempt <= options.retries) {
    attempts.push_back({made.scene.status, made.scene.messages});
    earlier.push_back(std::move(made.scene.frames));
    made = tryScene(scene, options, device, ++attempt);
    everHardFailed = everHardFailed || made.hardFailed;
  }
  SceneResult& result = made.scene;
  addAttempts(std::move(attempts), result, losses);
  for (std::size_t i = 0; i < earlier.size(); ++i)
    addEarlier(earlier[i], fmt::format("attempt {}", std::size_t(losses) + i + 1), result);
  applyExpectation(made);
  if (isFailure(result.status, false)) result.blame = blameOf(result);
  made.hardFailed = everHardFailed;
  result.seconds = secondsSince(begin);
  return made;
}

void addLosses(const std::vector<std::string>& losses, Outcome& made) {
  if (losses.empty()) return;
  SceneResult& result = made.scene;
  std::vector<Attempt> attempts;
  attempts.reserve(losses.size());
  for (const std::string& loss : losses) attempts.push_back({Status::error, {loss}});
  const bool passed = result.status == Status::pass;
  addAttempts(std::move(attempts), result);
  if (passed) result.blame = blameOf(result);
}

}  // namespace simreel::golden
