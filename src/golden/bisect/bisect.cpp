#include "golden/bisect/bisect.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/process.hpp"
#include "golden/bisect/child_command.hpp"
#include "golden/trace/traced_run.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace simreel::golden {

namespace {

/// Returns the shell command of a side, with `trace` and its arguments appended.
std::string traceCommand(const BisectSide& side, const std::vector<std::string>& more) {
  std::string command = side.command + " trace -q";
  for (const auto* words : {&side.arguments, &more})
    for (const std::string& word : *words) command += " " + inShellQuotes(word);
  return command;
}

/// Parses the output of a child process. Reports a parse error as an error of the child.
template <class Read>
auto understood(const ChildCommand& child, const Read& read) {
  try {
    return read();
  } catch (const std::runtime_error& error) {
    fail(ExitCode::inputOutput, "{} prints no trace that this simreel understands: {}", child.name(),
         error.what());
  }
}

/// A `trace` process of one side.
class Tracing {
 public:
  Tracing(const BisectSide& side, const std::vector<std::string>& arguments)
      : child_(traceCommand(side, arguments), side.name) {}

  TraceHeader header() {
    const auto line = child_.line();
    if (!line) endedEarly("its header");
    return understood(child_, [&] { return readHeaderLine(*line); });
  }
  /// Returns the next state line, or nothing after the last one.
  std::optional<StateLine> state() {
    const auto line = child_.line();
    if (!line) {
      child_.finish();
      return std::nullopt;
    }
    return understood(child_, [&] { return readStateLine(*line); });
  }
  StateDump dump(std::size_t maxBytes) {
    const auto bytes = child_.rest(maxBytes);
    child_.finish();
    return understood(child_, [&] { return readDump(bytes); });
  }
  PassDump passes() {
    constexpr std::size_t maxBytes = std::size_t{1} << 33;
    const auto bytes = child_.rest(maxBytes);
    child_.finish();
    return understood(child_, [&] { return readPasses(bytes); });
  }
  [[noreturn]] void endedEarly(const std::string& before) {
    child_.finish();
    fail(ExitCode::inputOutput, "{} ended before {}", child_.name(), before);
  }

 private:
  ChildCommand child_;
};

/// Throws UserError(usage) unless both sides step the same arrays from the same first frame.
void checkHeaders(const BisectSide& a, const TraceHeader& here, const BisectSide& b,
                  const TraceHeader& there, bool passes) {
  if (const auto mismatch = compareRuns(here.run, there.run))
    fail(ExitCode::usage, "the two sides do not simulate the same scene: {} {}, {} {}", a.name,
         mismatch->here, b.name, mismatch->there);
  if (here.run.arrays.empty() && !passes)
    fail(ExitCode::usage,
         "the scene has nothing that is simulated, so there is no state to compare; --passes compares its "
         "pictures");
}

std::size_t dumpBytes(const TraceHeader& header) {
  constexpr std::size_t maxHeaderBytes = std::size_t{1} << 20;
  std::size_t bytes = maxHeaderBytes;
  for (const TracedArray& array : header.run.arrays)
    bytes += static_cast<std::size_t>(array.elements) * bytesPerElement;
  return bytes;
}

class Search {
 public:
  Search(const BisectSide& here, const BisectSide& there) : here_(here), there_(there) {}

  BisectResult run(int lastFrame, bool passes) {
    result_.lastFrame = lastFrame;
    result_.passes = passes;
    const auto frame = firstFrame(lastFrame);
    if (!frame) return result_;
    if (pictureDiffers_) {
      comparePictures(*frame);
      return result_;
    }
    result_.difference.emplace();
    result_.difference->frame = *frame;
    if (*frame > result_.here.run.firstFrame) {
      const auto step = firstStep(*frame);
      if (!step) {
        unstable(fmt::format("frame {} differed at first and not when it was run again", *frame));
        return result_;
      }
      result_.difference->step = step->step;
      result_.difference->steps = step->steps;
      elements(step->object);
    } else {
      elements({});
    }
    return result_;
  }

 private:
  /// Returns the next lines of both sides, or nothing after the last lines. Fails unless both lines are for
  /// the same step. `before`: text for the message if one side ends early.
  std::optional<std::pair<StateLine, StateLine>> nextLines(Tracing& a, Tracing& b,
                                                           const std::string& before) {
    const auto x = a.state();
    const auto y = b.state();
    if (!x && !y) return std::nullopt;
    if (!x) a.endedEarly(before);
    if (!y) b.endedEarly(before);
    if (x->frame != y->frame || x->object != y->object || x->step != y->step)
      fail(ExitCode::inputOutput, "the traces of {} and {} list different steps", here_.name, there_.name);
    return std::pair(*x, *y);
  }

  std::optional<int> firstFrame(int lastFrame) {
    detail("bisect: both sides up to frame {}", lastFrame);
    std::vector<std::string> arguments = {fmt::format("--frames=start-{}", lastFrame)};
    if (result_.passes) arguments.emplace_back("--passes");
    Tracing a(here_, arguments);
    Tracing b(there_, arguments);
    result_.here = a.header();
    result_.there = b.header();
    checkHeaders(here_, result_.here, there_, result_.there, result_.passes);
    int read = 0;
    for (; const auto lines = nextLines(a, b, fmt::format("frame {}", lastFrame)); ++read) {
      pictureDiffers_ =
          lines->first.arrays == lines->second.arrays && lines->first.passes != lines->second.passes;
      if (lines->first.arrays != lines->second.arrays || pictureDiffers_) return lines->first.frame;
    }
    const int expected = lastFrame - result_.here.run.firstFrame + 1;
    if (read != expected)
      fail(ExitCode::inputOutput, "both traces ended after {} of {} frames", read, expected);
    return std::nullopt;
  }

  std::optional<StateLine> firstStep(int frame) {
    detail("bisect: the steps of frame {}", frame);
    const std::vector<std::string> arguments = {fmt::format("--steps-of={}", frame)};
    Tracing a(here_, arguments);
    Tracing b(there_, arguments);
    static_cast<void>(a.header());
    static_cast<void>(b.header());
    std::optional<StateLine> first;
    while (const auto lines = nextLines(a, b, fmt::format("the last step of frame {}", frame))) {
      const auto& [x, y] = *lines;
      if (x.arrays == y.arrays) continue;
      if (!first || isEarlierStep(x.step, x.steps, first->step, first->steps)) first = x;
    }
    return first;
  }

  /// Compares the arrays of `object` after the step that was found. If `object` is empty, uses the first
  /// object that differs.
  void elements(const std::string& object) {
    StateDifference& found = *result_.difference;
    detail("bisect: the state after step {} of frame {}", found.step, found.frame);
    const std::vector<std::string> arguments = {fmt::format("--dump={}:{}", found.frame, found.step), "-o",
                                                "-"};
    Tracing a(here_, arguments);
    Tracing b(there_, arguments);
    const StateDump here = a.dump(dumpBytes(result_.here));
    const StateDump there = b.dump(dumpBytes(result_.there));
    if (here.arrays.size() != there.arrays.size())
      fail(ExitCode::inputOutput, "the dumps of {} and {} hold different arrays", here_.name, there_.name);
    std::string wanted = object;
    for (std::size_t i = 0; i < here.arrays.size(); ++i) {
      const StateDump::Array& x = here.arrays[i];
      const StateDump::Array& y = there.arrays[i];
      if (x.object != y.object || x.array != y.array || x.words.size() != y.words.size())
        fail(ExitCode::inputOutput, "the dumps of {} and {} hold different arrays", here_.name,
             there_.name);
      if (!wanted.empty() && x.object != wanted) continue;
      const ArrayDifference difference = compareWords(x.words, y.words);
      if (difference.differing == 0) continue;
      wanted = x.object;
      found.arrays.push_back({x.object, x.array, difference});
    }
    if (found.arrays.empty())
      unstable(fmt::format("step {} of frame {} differed at first and not when it was run again",
                           found.step, found.frame));
  }

  /// Compares the passes of a frame's pictures. The states are equal.
  void comparePictures(int frame) {
    detail("bisect: the passes of frame {}", frame);
    const std::vector<std::string> arguments = {fmt::format("--dump={}:passes", frame), "-o", "-"};
    PassDump dumps[2];
    for (const int i : {0, 1}) dumps[i] = Tracing(i == 0 ? here_ : there_, arguments).passes();
    result_.pass = comparePasses(dumps[0], dumps[1]);
    if (result_.pass) return;
    result_.pass.emplace();
    result_.pass->frame = frame;
    result_.pass->unstable = whyUnstable(
        fmt::format("the picture of frame {} differed at first and not when it was drawn again", frame));
  }

  static std::string whyUnstable(const std::string& why) {
    return why +
           "; a side does not repeat itself (`simreel bisect` without --against compares one with itself)";
  }
  void unstable(const std::string& why) { result_.difference->unstable = whyUnstable(why); }

  const BisectSide& here_;
  const BisectSide& there_;
  BisectResult result_;
  /// true if the first difference is in the picture of a frame with equal states
  bool pictureDiffers_ = false;
};

}  // namespace

BisectResult bisect(const BisectSide& here, const BisectSide& there, int lastFrame, bool passes) {
  return Search(here, there).run(lastFrame, passes);
}

}  // namespace simreel::golden
