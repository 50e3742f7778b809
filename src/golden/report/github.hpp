#pragma once
#include "golden/result.hpp"

#include <string>

namespace simreel::golden {

/// Returns workflow commands for GitHub's log ("::error file=...,title=...::..."), one per line. There is
/// an error for each scene that fails the run. There is a warning for each flaky scene that does not fail
/// the run, and for each note that contains "loose". There is a notice for updated baselines. Annotations
/// name the file and line that caused the result. GitHub shows at most ten of each kind. If there are more,
/// returns nine of them and one with the number of omitted annotations.
[[nodiscard]] std::string githubAnnotations(const SuiteResult& suite);
}  // namespace simreel::golden
