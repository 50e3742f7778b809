#include "golden/report/outcome.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <utility>

namespace simreel::golden {

// The format is one character '0' + exit code, one character '0' or '1' for hardFailed, then the report of
// a run of this single scene.

std::string outcomeText(Outcome outcome) {
  SuiteResult alone;
  alone.stale = std::move(outcome.stale);
  alone.scenes.push_back(std::move(outcome.scene));
  std::string head = {static_cast<char>('0' + static_cast<int>(outcome.error)),
                      outcome.hardFailed ? '1' : '0'};
  return head + reportText(alone);
}

Outcome parseOutcome(const std::string& text) {
  SuiteResult alone = parseReport(text.substr(std::min<std::size_t>(2, text.size())), "worker");
  if (alone.scenes.size() != 1)
    fail(ExitCode::inputOutput, "a process that tested one scene reported {} scenes", alone.scenes.size());
  Outcome outcome;
  outcome.error = static_cast<ExitCode>(text[0] - '0');
  outcome.hardFailed = text[1] == '1';
  outcome.scene = std::move(alone.scenes.front());
  outcome.stale = std::move(alone.stale);
  return outcome;
}

}  // namespace simreel::golden
