#include "golden/bisect.hpp"

#include "base/error.hpp"

#include <bit>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace {

using Json = nlohmann::ordered_json;

/// A child whose output is read line by line. Closing before its end stops it at its next line.
class Child {
 public:
  explicit Child(const std::string& command) : command_(command), pipe_(::popen(command.c_str(), "r")) {
    if (pipe_ == nullptr) fail(ExitCode::inputOutput, "cannot run {}", command);
  }
  ~Child() {
    if (pipe_ != nullptr) ::pclose(pipe_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Nothing at the end, which has to be a good one.
  std::optional<Json> line() {
    std::string text;
    for (int c = std::fgetc(pipe_); c != EOF && c != '\n'; c = std::fgetc(pipe_))
      text += static_cast<char>(c);
    if (text.empty()) {
      finish();
      return std::nullopt;
    }
    Json json = Json::parse(text, nullptr, false);
    if (!json.is_object())
      fail(ExitCode::inputOutput, "{} does not answer as `simreel trace` does", command_);
    return json;
  }
  Json needLine() {
    auto json = line();
    if (!json) fail(ExitCode::inputOutput, "{} ended early", command_);
    return std::move(*json);
  }
  void read(void* to, std::size_t size) {
    if (std::fread(to, 1, size, pipe_) != size) {
      finish();
      fail(ExitCode::inputOutput, "{} ended early", command_);
    }
  }
  [[nodiscard]] const std::string& command() const { return command_; }

 private:
  /// What went wrong the child has said on standard error.
  void finish() {
    const int status = ::pclose(std::exchange(pipe_, nullptr));
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    fail(ExitCode::inputOutput, "{} failed with {} {}", command_, WIFEXITED(status) ? "status" : "signal",
         WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status));
  }
  std::string command_;
  std::FILE* pipe_;
};

struct Pair {
  Pair(const Side (&sides)[2], const std::string& options)
      : a(sides[0].command + " " + options), b(sides[1].command + " " + options) {}
  Child a, b;
};

template <class T>
T member(const Json& json, const char* key, const Child& child) {
  try {
    return json.at(key).get<T>();
  } catch (const Json::exception&) {
    fail(ExitCode::inputOutput, "{} does not answer as `simreel trace` does: \"{}\" is missing",
         child.command(), key);
  }
}

/// Compares frame by frame; the first that differs, if any.
std::optional<int> firstFrame(const Side (&sides)[2], std::optional<int> last, Bisection& found,
                              Json& steps) {
  Pair pair(sides, last ? fmt::format("--last {}", *last) : "");
  const Json heads[2] = {pair.a.needLine(), pair.b.needLine()};
  found.drivers[0] = member<std::string>(heads[0], "driver", pair.a);
  found.drivers[1] = member<std::string>(heads[1], "driver", pair.b);
  found.versions[0] = member<std::string>(heads[0], "simreel", pair.a);
  found.versions[1] = member<std::string>(heads[1], "simreel", pair.b);
  for (const char* key : {"first", "steps", "arrays"})
    if (member<Json>(heads[0], key, pair.a) != member<Json>(heads[1], key, pair.b))
      fail(ExitCode::usage, "the two sides do not simulate the same: \"{}\" is {} here and {} there", key,
           heads[0][key].dump(), heads[1][key].dump());
  steps = heads[0]["steps"];
  while (true) {
    const auto a = pair.a.line();
    const auto b = pair.b.line();
    if (!a && !b) return std::nullopt;
    if (!a || !b) fail(ExitCode::inputOutput, "{} ended early", (a ? pair.b : pair.a).command());
    ++found.frames;
    if (*a != *b) return member<int>(*a, "frame", pair.a);
  }
}

/// The first step of the frame at which an array differs, as seen by both sides.
void firstStep(const Side (&sides)[2], Difference& found) {
  Pair pair(sides, fmt::format("--steps-of {}", found.frame));
  static_cast<void>(pair.a.needLine());
  static_cast<void>(pair.b.needLine());
  bool any = false;
  while (true) {
    const auto a = pair.a.line();
    const auto b = pair.b.line();
    if (!a || !b) break;
    const int step = member<int>(*a, "step", pair.a);
    if (*a == *b || (any && step >= found.step)) continue;
    any = true;
    found.step = step;
    found.object = member<std::string>(*a, "object", pair.a);
  }
  if (!any)
    fail(ExitCode::inputOutput,
         "frame {} differed, but its steps do not: a side is not deterministic; test it with "
         "--repeat",
         found.frame);
}

/// Floats in the order of their values: neighbours differ by one.
std::int64_t ordered(std::uint32_t bits) {
  const auto magnitude = static_cast<std::int64_t>(bits & 0x7fffffffU);
  return (bits >> 31) != 0 ? -magnitude : magnitude;
}

/// Compares the object's arrays, up to the first one that differs; false when none does.
bool firstElement(const Side (&sides)[2], Difference& found) {
  Pair pair(sides, fmt::format("--dump={}:{} --object {}", found.frame, found.step, found.object));
  const Json head = pair.a.needLine();
  if (head != pair.b.needLine()) fail(ExitCode::usage, "the two sides do not have the same arrays");
  for (const Json& array : head.at("arrays")) {
    const auto words = static_cast<std::size_t>(member<long>(array, "elements", pair.a)) * 4;
    std::vector<std::uint32_t> a(words), b(words);
    pair.a.read(a.data(), words * 4);
    pair.b.read(b.data(), words * 4);
    long counted = -1;
    for (std::size_t i = 0; i < words; ++i) {
      if (a[i] == b[i]) continue;
      if (found.elementsThatDiffer == 0) {
        found.array = member<std::string>(array, "array", pair.a);
        found.element = static_cast<long>(i / 4);
        found.component = static_cast<int>(i % 4);
        found.words[0] = a[i];
        found.words[1] = b[i];
      }
      if (static_cast<long>(i / 4) != counted) ++found.elementsThatDiffer;
      counted = static_cast<long>(i / 4);
      const std::int64_t apart = std::abs(ordered(a[i]) - ordered(b[i]));
      found.mostUlp =
          std::max(found.mostUlp, static_cast<std::uint32_t>(std::min<std::int64_t>(apart, 0xffffffff)));
    }
    if (found.elementsThatDiffer > 0) return true;
  }
  return false;
}

}  // namespace

Bisection bisect(const Side (&sides)[2], std::optional<int> lastFrame) {
  Bisection found;
  Json steps;
  const auto frame = firstFrame(sides, lastFrame, found, steps);
  if (!frame) return found;
  Difference& difference = found.difference.emplace();
  difference.frame = *frame;
  if (found.frames == 1) {  // the state that both start from
    for (const auto& [object, count] : steps.items()) {
      difference.object = object;
      if (firstElement(sides, difference)) return found;
    }
  } else {
    firstStep(sides, difference);
    difference.steps = steps.at(difference.object).get<int>();
    if (firstElement(sides, difference)) return found;
  }
  fail(ExitCode::inputOutput,
       "frame {} differed, but its arrays are equal now: a side is not deterministic", difference.frame);
}

}  // namespace simreel::golden
