#pragma once
#include "golden/result.hpp"

#include <string>

namespace simreel::golden {

/// Workflow commands for GitHub's log ("::error file=...,title=...::..."), a line each: an error for every
/// scene that fails the run, a warning for a flaky one that does not and for every note that speaks of a
/// loose tolerance (holds "loose"), a notice for updated baselines. They name the file and the line that is
/// to blame. Of more than ten of a kind, which servers do not show, nine are left and one counts the rest.
[[nodiscard]] std::string githubAnnotations(const SuiteResult& suite);
}  // namespace simreel::golden
