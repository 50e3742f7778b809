#include "golden/suite/suite.hpp"

#include "base/clock.hpp"
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

struct Try {
  SceneResult result;
  ExitCode error = ExitCode::ok;
  bool hardFailed = false;
  std::vector<Stale> stale;
};

Try tryScene(const SceneFile& scene, const SuiteOptions& options, const Device& device, int attempt) {
  SceneTest test(scene, options, device, attempt);
  Try made;
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
  made.result = std::move(test.result());
  made.stale = std::move(test.stale());
  return made;
}

/// Adds the pictures of an earlier attempt to the frames of the last.
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

/// A failure that the scene announces is expected, unless hardFail forbids it.
void applyExpectation(Try& made) {
  SceneResult& result = made.result;
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

Suite::Suite(SuiteOptions options, Device device)
    : options_(std::move(options)), device_(std::move(device)) {}

SceneResult Suite::test(const SceneFile& scene) {
  const auto begin = Clock::now();
  std::vector<Attempt> attempts;
  std::vector<std::vector<FrameResult>> earlier;  // frames of those attempts
  Try made = tryScene(scene, options_, device_, 1);
  bool everHardFailed = made.hardFailed;
  while (made.result.xfail.empty() && mayPassOnRetry(made.result.status) &&
         static_cast<int>(attempts.size()) < options_.retries) {
    attempts.push_back({made.result.status, made.result.messages});
    earlier.push_back(std::move(made.result.frames));
    made = tryScene(scene, options_, device_, static_cast<int>(attempts.size()) + 1);
    everHardFailed = everHardFailed || made.hardFailed;
  }
  SceneResult& result = made.result;
  if (!attempts.empty() && result.status == Status::pass) {
    result.status = Status::flaky;
    result.messages.push_back(fmt::format("passed on try {}; before that: {}", attempts.size() + 1,
                                          attempts.front().messages.empty()
                                              ? statusName(attempts.front().status)
                                              : attempts.front().messages.front()));
  }
  result.attempts = std::move(attempts);
  for (std::size_t i = 0; i < earlier.size(); ++i)
    addEarlier(earlier[i], fmt::format("attempt {}", i + 1), result);
  stale_.insert(stale_.end(), made.stale.begin(), made.stale.end());
  applyExpectation(made);
  result.seconds = secondsSince(begin);

  tally_.add(result.status, options_.allowFlaky && !everHardFailed, made.error);
  return std::move(made.result);
}

}  // namespace simreel::golden
